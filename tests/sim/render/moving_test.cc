// What moves is drawn where it is.
#include <cmath>
#include <cstring>
#include <optional>

#include <gtest/gtest.h>

#include "sim/render/stereo_renderer.h"
#include "tests/sim/world/creature_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class MovingTest : public ::testing::Test {
 protected:
  static constexpr Pinhole kPinhole{400, 300, 290.0, 199.5, 149.5};
  static constexpr double kFar = 20.0;

  /// Looks along x.
  static Pose Eye(double y) { return {Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.0, y, 0.0}}; }

  std::filesystem::path Scene() const {
    return testing::WriteScene(folder_.path(),
                               testing::BoxElement("wall", {9.0, 0.0, 0.0}, {0.2, 20.0, 20.0}));
  }
  /// One fish that crosses the view, 3 m ahead.
  MovingThings Fish() const {
    ShoalConfig shoal;
    shoal.centre_m = {3.0, 0.0, 0.0};
    shoal.radius_m = 0.8;
    shoal.size_m = 0.3;
    return {{{shoal, 2.0, 6.0}}, creatures_, 5};
  }

  /// Middle and depth of what is red, if anything is.
  struct Spot {
    Vector2d pixel = Vector2d::Zero();
    double depth = 0.0;
    int pixels = 0;
  };
  static std::optional<Spot> Red(const RawImage& image) {
    Spot spot;
    for (int v = 0; v < image.albedo.rows; ++v) {
      for (int u = 0; u < image.albedo.cols; ++u) {
        const auto color = image.albedo.at<cv::Vec3b>(v, u);
        if (color[0] < 100 || color[1] > 50) continue;
        spot.pixel += Vector2d(u, v);
        spot.depth += image.depth.at<float>(v, u);
        ++spot.pixels;
      }
    }
    if (spot.pixels == 0) return std::nullopt;
    spot.pixel /= spot.pixels;
    spot.depth /= spot.pixels;
    return spot;
  }
  static Vector2d Project(const Pose& T_WC, const Vector3d& p_W) {
    const Vector3d p = T_WC.Inverse() * p_W;
    return {kPinhole.focal * p.x() / p.z() + kPinhole.cx,
            kPinhole.focal * p.y() / p.z() + kPinhole.cy};
  }

  testing::TemporaryFolder folder_;
  Creatures creatures_ = testing::WriteCreatures(folder_.path());
};

TEST_F(MovingTest, AFishIsSeenWhereItIsInBothEyes) {
  World world(Scene(), Fish());
  StereoRenderer renderer(world, RendererBackend::kAuto, {kPinhole, kPinhole}, kFar);
  const std::array<Pose, 2> eyes = {Eye(0.07), Eye(-0.07)};
  Vector2d before(1e9, 1e9);
  for (double t = 2.1; t < 5.9; t += 0.4) {
    const MovingPoses poses = world.moving().At(Time::FromSeconds(t), Pose());
    renderer.Begin(eyes, poses);
    const RawPair& pair = renderer.Finish();
    // The middle of the fish's three boxes, by the area of their sides.
    const double size = world.moving().bodies()[0].scale;
    const Vector3d middle = *poses[0] * Vector3d(0.16 * size, 0, 0) * 0.52 +
                            *poses[1] * Vector3d(-0.2 * size, 0, 0) * 0.20 +
                            *poses[2] * Vector3d(-0.44 * size, 0, 0) * 0.28;
    for (std::size_t eye = 0; eye < 2; ++eye) {
      const std::optional<Spot> spot = Red(pair[eye]);
      ASSERT_TRUE(spot.has_value()) << t;
      EXPECT_LT((spot->pixel - Project(eyes[eye], middle)).norm(), 4.0) << t;
      EXPECT_NEAR(spot->depth, (eyes[eye].Inverse() * middle).z(), 0.08) << t;
      EXPECT_GT(spot->pixels, 40) << t;
    }
    // Disparity and depth agree.
    const double disparity = Red(pair[0])->pixel.x() - Red(pair[1])->pixel.x();
    EXPECT_NEAR(disparity, kPinhole.focal * 0.14 / Red(pair[0])->depth, 1.0) << t;
    EXPECT_GT((Red(pair[0])->pixel - before).norm(), 2.0) << t;
    before = Red(pair[0])->pixel;
  }
}

TEST_F(MovingTest, NothingIsSeenOfItBeforeAndAfter) {
  RawImage expected;
  {
    World still(Scene());
    Renderer without(still, RendererBackend::kAuto, kPinhole.width, kPinhole.height);
    without.Render(Eye(0.0), kPinhole, expected);
  }
  World world(Scene(), Fish());
  Renderer renderer(world, RendererBackend::kAuto, kPinhole.width, kPinhole.height);
  const auto expect_nothing = [&](double t) {
    RawImage image;
    renderer.Place(world.moving().At(Time::FromSeconds(t), Pose()));
    renderer.Render(Eye(0.0), kPinhole, image);
    EXPECT_EQ(0, std::memcmp(image.albedo.data, expected.albedo.data, 3 * image.albedo.total()));
    EXPECT_EQ(0, std::memcmp(image.depth.data, expected.depth.data, 4 * image.depth.total()));
  };
  RawImage image;
  renderer.Render(Eye(0.0), kPinhole, image);  // Not placed yet.
  EXPECT_FALSE(Red(image).has_value());
  expect_nothing(1.9);
  renderer.Place(world.moving().At(Time::FromSeconds(4.0), Pose()));
  renderer.Render(Eye(0.0), kPinhole, image);
  EXPECT_TRUE(Red(image).has_value());
  expect_nothing(6.1);
  renderer.Place(world.moving().At(Time::FromSeconds(4.0), Pose()));
  renderer.Place({});
  renderer.Render(Eye(0.0), kPinhole, image);
  EXPECT_FALSE(Red(image).has_value());
}

// Its box moves along with it, or it would be culled where it has come to.
TEST_F(MovingTest, IsCulledByWhereItIs) {
  World world(Scene(), Fish());
  Renderer renderer(world, RendererBackend::kAuto, kPinhole.width, kPinhole.height);
  const auto pixels = [&](const Pose& T_WB) {
    RawImage image;
    renderer.Place({T_WB, std::nullopt, std::nullopt});
    renderer.Render(Eye(0.0), kPinhole, image);
    const std::optional<Spot> spot = Red(image);
    return spot ? spot->pixels : 0;
  };
  EXPECT_EQ(pixels(Pose(Eigen::Quaterniond::Identity(), {-3.0, 0.0, 0.0})), 0);
  const int seen = pixels(Pose(FromYawPitchRoll(1.5, 0.0, 0.0), {3.0, 0.0, 0.0}));
  EXPECT_GT(seen, 100);
  const int aside = pixels(Pose(FromYawPitchRoll(1.5, 0.0, 0.0), {3.0, 1.95, 0.0}));
  EXPECT_GT(aside, 0.6 * seen);
}

}  // namespace
}  // namespace drydock::sim
