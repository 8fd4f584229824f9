// What moves in the camera's pictures.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "sim/sensors/stereo_camera.h"
#include "tests/sim/sensors/still_motion.h"
#include "tests/sim/world/creature_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

bool Same(const StereoFrame& a, const StereoFrame& b) {
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const cv::Mat& image = a.images[eye];
    if (std::memcmp(image.data, b.images[eye].data, image.total() * image.elemSize()) != 0)
      return false;
  }
  return true;
}

class MovingCameraTest : public ::testing::Test {
 protected:
  std::filesystem::path Scene() const {
    return testing::WriteScene(folder_.path(),
                               testing::BoxElement("wall", {5.0, 0.0, 0.0}, {0.2, 9.0, 9.0}));
  }
  MovingThings Things(const MovingThingConfig& thing) const { return {{thing}, creatures_, 1}; }

  /// The first `count` frames of a dive that stands still, without noise.
  std::vector<StereoFrame> Frames(MovingThings things, int count) {
    World world(Scene(), std::move(things));
    const RayScene rays(world);
    StereoCamera camera({motion_, world, rays, motion_.End()}, rig_.stereo, Water(), {}, Config(),
                        RendererBackend::kAuto, 1);
    std::vector<StereoFrame> frames;
    frames.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
      frames.push_back(std::get<StereoFrame>(camera.Observe().measurement.reading));
    return frames;
  }
  static WaterConfig Water() {
    WaterConfig water;
    water.shadows = false;
    return water;
  }
  static StereoCameraConfig Config() {
    StereoCameraConfig config;
    config.image.noise = false;
    config.image.exposure = 2.0;
    return config;
  }

  testing::TemporaryFolder folder_;
  Creatures creatures_ = testing::WriteCreatures(folder_.path());
  Rig rig_ = LoadRig(FindRig("svin2_v3"));
  StillMotion motion_{Pose::Identity()};
};

// Each frame shows the fish of its own time, not of the one that is drawn ahead.
TEST_F(MovingCameraTest, FramesShowWhatMovesWhereItIsAtTheirTime) {
  ShoalConfig shoal;
  shoal.count = 5;
  shoal.centre_m = {2.5, 0.0, 0.0};
  shoal.radius_m = 0.7;
  const MovingThingConfig thing{shoal, 0.0, 0.23};
  const std::vector<StereoFrame> still = Frames({}, 5);
  const std::vector<StereoFrame> frames = Frames(Things(thing), 5);
  EXPECT_TRUE(Same(still[0], still[4]));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_FALSE(Same(frames[k], still[k])) << k;
    EXPECT_FALSE(Same(frames[k], frames[k + 1])) << k;
  }
  EXPECT_TRUE(Same(frames[4], still[4]));  // At 0.267 s they are gone.

  World world(Scene(), Things(thing));
  const RayScene rays(world);
  StereoCamera camera({motion_, world, rays, motion_.End()}, rig_.stereo, Water(), {}, Config(),
                      RendererBackend::kAuto, 1);
  EXPECT_TRUE(Same(camera.Look(Pose(), nullptr, Time::FromSeconds(2.0 / 15.0)), frames[2]));
}

// The arm stays where it is in the view wherever the body goes, and hides what is behind it.
TEST_F(MovingCameraTest, TheArmIsInTheLowerCornerOfItsSide) {
  for (const bool left : {false, true}) {
    DiverArmConfig arm;
    arm.left = left;
    World world(Scene(), Things({arm, 0.0, 1e9}));
    const RayScene rays(world);
    StereoCamera camera({motion_, world, rays, motion_.End()}, rig_.stereo, Water(), {}, Config(),
                        RendererBackend::kAuto, 1);
    for (const Pose& T_WI : {Pose(), Pose(FromYawPitchRoll(0.4, -0.1, 0.2), {1.0, 0.5, 0.2})}) {
      StereoTruth truth;
      camera.Look(T_WI, &truth);
      for (std::size_t eye = 0; eye < 2; ++eye) {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        int pixels = 0;
        for (int v = 0; v < truth.depth[eye].rows; ++v) {
          for (int u = 0; u < truth.depth[eye].cols; ++u) {
            if (truth.depth[eye].at<float>(v, u) > 0.8F) continue;
            middle += Eigen::Vector2d(u, v);
            ++pixels;
          }
        }
        ASSERT_GT(pixels, 2000) << left << " " << eye;
        middle /= pixels;
        EXPECT_LT(pixels, 120000) << left << " " << eye;
        EXPECT_GT(middle.y(), 320.0) << left << " " << eye;
        EXPECT_EQ(middle.x() < 400.0, left) << left << " " << eye << " " << middle.x();
      }
    }
  }
}

}  // namespace
}  // namespace drydock::sim
