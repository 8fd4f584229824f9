#include "sim/sensors/stereo_camera.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/sim/sensors/still_motion.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

/// Centre of the brightest spot.
Eigen::Vector2d Spot(const cv::Mat& grey) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u)
      sum += std::pow(grey.at<unsigned char>(v, u), 6.0) * Eigen::Vector3d(u, v, 1);
  }
  return sum.head<2>() / sum.z();
}

class StereoCameraTest : public ::testing::Test {
 protected:
  static std::filesystem::path Scene(const std::filesystem::path& folder) {
    return testing::WriteScene(folder, testing::MarkerElement(kMarker, {-1, 0, 0}, 0.06));
  }

  StereoCamera MakeCamera(const WaterConfig& water, const std::vector<LampConfig>& lamps,
                          const StereoCameraConfig& config) {
    return {{motion_, world_, rays_, motion_.End()},
            rig_.stereo,
            water,
            lamps,
            config,
            RendererBackend::kAuto,
            1};
  }
  StereoCamera MakeCamera(const WaterConfig& water, const ImageSensorConfig& image,
                          bool depth_images) {
    return MakeCamera(water, {}, {image, {}, depth_images});
  }
  /// Without noise, at a fixed exposure.
  static StereoCameraConfig PlainCamera() {
    StereoCameraConfig config;
    config.image.noise = false;
    config.image.exposure = 50.0;
    return config;
  }

  static inline const Eigen::Vector3d kMarker{2.0, 0.2, 0.1};
  testing::TemporaryFolder folder_;
  World world_{Scene(folder_.path())};
  RayScene rays_{world_};
  Rig rig_ = LoadRig(FindRig("svin2_v3"));
  StillMotion motion_{Pose::Identity()};
};

// Both eyes, through renderer, water, lens and sensor: a marker appears where each camera's model
// has it, and nearer ones with the disparity of the baseline.
TEST_F(StereoCameraTest, LeftAndRightAreConsistent) {
  WaterConfig water;
  water.visibility_m = 0.0;
  water.sun_share = 0.0;
  water.surface_z_m = 0.0;
  ImageSensorConfig image;
  image.noise = false;
  image.exposure = 1.6;
  StereoCamera camera = MakeCamera(water, image, true);
  const Observation observation = camera.Observe();
  const auto& frame = std::get<StereoFrame>(observation.measurement.reading);
  std::array<Eigen::Vector2d, 2> spots;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    ASSERT_EQ(frame.images[eye].type(), CV_8UC1);
    ASSERT_EQ(frame.images[eye].size(), cv::Size(800, 600));
    const CameraModel model(rig_.stereo.cameras[eye]);
    spots[eye] = Spot(frame.images[eye]);
    EXPECT_LT((spots[eye] - *model.Project(rig_.stereo.T_IC[eye].Inverse() * kMarker)).norm(), 0.3);
  }
  EXPECT_NEAR(spots[0].x() - spots[1].x(), 575.0 * 0.143 / 1.96, 2.0);
  const auto& truth = std::get<StereoTruth>(observation.truth);
  const auto at_spot =
      truth.depth[0].at<float>(static_cast<int>(spots[0].y()), static_cast<int>(spots[0].x()));
  EXPECT_NEAR(at_spot, 1.96, 0.001);
}

TEST_F(StereoCameraTest, SameBytesTwice) {
  StereoCamera camera = MakeCamera(WaterConfig{}, ImageSensorConfig{}, false);
  const StereoFrame first = camera.Look(Pose::Identity(), nullptr);
  camera.Look(Pose(FromYawPitchRoll(0.5, 0.1, 0.0), {0.2, 0, 0}), nullptr);
  const StereoFrame again = camera.Look(Pose::Identity(), nullptr);
  for (std::size_t eye = 0; eye < 2; ++eye) {
    EXPECT_EQ(
        0, std::memcmp(first.images[eye].data, again.images[eye].data, first.images[eye].total()));
  }
}

// Fixed exposure in a still view: frames differ by their noise only, which another switch takes
// off.
TEST_F(StereoCameraTest, NoiseIsNewInEachFrame) {
  ImageSensorConfig image;
  for (const bool noise : {true, false}) {
    image.noise = noise;
    StereoCamera camera = MakeCamera(WaterConfig{}, image, false);
    const auto first = std::get<StereoFrame>(camera.Observe().measurement.reading);
    const auto second = std::get<StereoFrame>(camera.Observe().measurement.reading);
    EXPECT_EQ(first.index, 0);
    EXPECT_EQ(second.index, 1);
    const bool same =
        0 == std::memcmp(first.images[0].data, second.images[0].data, first.images[0].total());
    EXPECT_EQ(same, !noise);
  }
}

// Whatever the light, the mean of the picture settles where the sheet wants it.
TEST_F(StereoCameraTest, ExposesByItself) {
  ImageSensorConfig image;
  image.vignetting = false;
  WaterConfig water;
  for (const double daylight : {1.0, 0.1}) {
    water.daylight = daylight;
    StereoCamera camera = MakeCamera(water, image, false);
    const StereoFrame frame = camera.Look(Pose::Identity(), nullptr);
    double light = 0.0;
    for (int v = 0; v < 600; ++v) {
      for (int u = 0; u < 800; ++u)
        light += std::pow(frame.images[0].at<unsigned char>(v, u) / 255.0, 2.2) / 480'000.0;
    }
    EXPECT_NEAR(light, rig_.stereo.imager.auto_exposure_target, 0.01);
  }
}

// At night there is what the lamps show, and else nothing.
TEST_F(StereoCameraTest, SeesByLamps) {
  WaterConfig water;
  water.daylight = 0.0;
  StereoCamera dark = MakeCamera(water, {}, PlainCamera());
  EXPECT_EQ(cv::norm(dark.Look(Pose::Identity(), nullptr).images[0]), 0.0);
  LampConfig lamp;
  lamp.position_m = {0.1, 0.4, 0.1};
  StereoCamera lit = MakeCamera(water, {lamp}, PlainCamera());
  const StereoFrame frame = lit.Look(Pose::Identity(), nullptr);
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const CameraModel model(rig_.stereo.cameras[eye]);
    const Eigen::Vector2d marker = *model.Project(rig_.stereo.T_IC[eye].Inverse() * kMarker);
    const auto x = static_cast<int>(marker.x()), y = static_cast<int>(marker.y());
    EXPECT_GT(frame.images[eye].at<unsigned char>(y, x),
              frame.images[eye].at<unsigned char>(y, x + 40) + 20);
  }
}

// Snow, silt and waves are where they are at the frame's time.
TEST_F(StereoCameraTest, WhatDriftsIsSeenAtItsTime) {
  WaterConfig plain;
  plain.surface_z_m = 3.0;
  plain.shadows = false;
  plain.sun_share = 1.0;
  plain.sun_azimuth_deg = 180.0;  // On the marker's face.
  plain.sun_elevation_deg = 45.0;
  WaterConfig snow = plain, silt = plain, waves = plain;
  snow.snow = MarineSnowConfig{};
  silt.silt = {{.position_m = {1.5, 0.0, 0.0}, .current_m_s = {0.0, 0.3, 0.0}}};
  waves.caustics.slope_rms = 0.1;
  StereoCameraConfig config = PlainCamera();
  config.image.exposure = 3.0;
  const auto look = [](StereoCamera& camera, double t_s) {
    return camera.Look(Pose::Identity(), nullptr, Time::FromSeconds(t_s)).images[0];
  };
  cv::Mat without;
  {
    StereoCamera camera = MakeCamera(plain, {}, config);
    without = look(camera, 5.0);
    EXPECT_EQ(cv::norm(without, look(camera, 9.0), cv::NORM_INF), 0.0);
  }
  for (const WaterConfig& water : {snow, silt, waves}) {
    StereoCamera camera = MakeCamera(water, {}, config);
    const cv::Mat now = look(camera, 5.0);
    EXPECT_GT(cv::norm(now, without, cv::NORM_INF), 4.0);
    EXPECT_GT(cv::norm(now, look(camera, 9.0), cv::NORM_INF), 4.0);
    EXPECT_EQ(cv::norm(now, look(camera, 5.0), cv::NORM_INF), 0.0);
  }
}

// A port shifts what is nearer than where the sheet was calibrated.
TEST_F(StereoCameraTest, APortShiftsWhatIsNear) {
  WaterConfig water;
  water.visibility_m = 0.0;
  water.surface_z_m = 0.0;
  StereoCameraConfig config = PlainCamera();
  config.image.exposure = 1.6;
  const Pose near(Eigen::Quaterniond::Identity(), {1.4, 0.1, 0.0});
  const auto spot = [&](const Pose& T_WI) {
    return Spot(MakeCamera(water, {}, config).Look(T_WI, nullptr).images[0]);
  };
  const Eigen::Vector2d near_without = spot(near);
  const Eigen::Vector2d far_without = spot(Pose::Identity());
  config.flat_port.enabled = true;
  config.flat_port.distance_m = 0.05;
  EXPECT_LT((spot(Pose::Identity()) - far_without).norm(), 0.05);
  EXPECT_GT((spot(near) - near_without).norm(), 0.3);
}

TEST_F(StereoCameraTest, ColourIsBgr) {
  ImageSensorConfig image;
  image.color = true;
  StereoCamera camera = MakeCamera(WaterConfig{}, image, false);
  const StereoFrame frame = camera.Look(Pose::Identity(), nullptr);
  ASSERT_EQ(frame.images[0].type(), CV_8UC3);
  const auto water = frame.images[0].at<cv::Vec3b>(550, 50);
  EXPECT_GT(water[1], water[2]);  // More green than red.
}

}  // namespace
}  // namespace drydock::sim
