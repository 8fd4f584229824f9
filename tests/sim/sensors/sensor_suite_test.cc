#include "sim/sensors/sensor_suite.h"

#include <gtest/gtest.h>

#include "sim/motion/spline_motion.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

MotionConfig Straight() {
  MotionConfig config;
  config.sway = {0.02, 0.02};
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    Waypoint waypoint;
    waypoint.position = {x, 0.0, 0.0};
    config.waypoints.push_back(waypoint);
  }
  return config;
}

class SensorSuiteTest : public ::testing::Test {
 protected:
  std::vector<Observation> Collect(const SensorsConfig& config, std::uint64_t seed,
                                   double seconds) {
    SensorSuite suite(motion_, world_, rays_, rig_, config, WaterConfig{}, {},
                      RendererBackend::kAuto, seed, Time::FromSeconds(seconds));
    std::vector<Observation> observations;
    while (auto observation = suite.Next()) observations.push_back(*observation);
    return observations;
  }

  static SensorsConfig NoCamera() {
    SensorsConfig config;
    config.stereo.enabled = false;
    return config;
  }

  testing::TemporaryFolder folder_;
  World world_{
      testing::WriteScene(folder_.path(), testing::BoxElement("wall", {2, 3, 0}, {5, 1, 2}))};
  RayScene rays_{world_};
  SplineMotion motion_{Straight(), 1};
  Rig rig_ = LoadRig(FindRig("svin2_v3"));
};

template <typename Reading_>
std::vector<std::pair<Time, Reading_>> Select(const std::vector<Observation>& observations) {
  std::vector<std::pair<Time, Reading_>> selected;
  for (const Observation& observation : observations) {
    const auto* reading = std::get_if<Reading_>(&observation.measurement.reading);
    if (reading != nullptr) selected.emplace_back(observation.measurement.t, *reading);
  }
  return selected;
}

TEST_F(SensorSuiteTest, EachSensorFiresAtItsRate) {
  const auto observations = Collect(SensorsConfig{}, 1, 2.0);
  EXPECT_EQ(Select<ImuSample>(observations).size(), 201U);
  EXPECT_EQ(Select<SonarPing>(observations).size(), 201U);
  EXPECT_EQ(Select<DepthSample>(observations).size(), 3U);
  const auto frames = Select<StereoFrame>(observations);
  ASSERT_EQ(frames.size(), 31U);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].first.ns, static_cast<std::int64_t>(k) * 1'000'000'000 / 15);
    EXPECT_EQ(frames[k].second.index, static_cast<std::int64_t>(k));
  }
}

TEST_F(SensorSuiteTest, ArrivalsAreOrderedAndTheImuComesFirst) {
  SensorsConfig config = NoCamera();
  config.depth.latency = Duration{35'000'000};
  config.sonar.latency = Duration{4'000'000};
  const auto observations = Collect(config, 1, 2.0);
  for (std::size_t i = 1; i < observations.size(); ++i) {
    EXPECT_GE(observations[i].measurement.t_arrival, observations[i - 1].measurement.t_arrival);
    EXPECT_GE(observations[i].measurement.t_arrival, observations[i].measurement.t);
  }
  // Nothing is lost to latency.
  EXPECT_EQ(Select<DepthSample>(observations).size(), 3U);
  EXPECT_EQ(Select<SonarPing>(observations).size(), 201U);
  const auto same_instant = Collect(NoCamera(), 1, 0.0);
  ASSERT_EQ(same_instant.size(), 3U);
  EXPECT_TRUE(std::holds_alternative<ImuSample>(same_instant[0].measurement.reading));
  EXPECT_TRUE(std::holds_alternative<DepthSample>(same_instant[1].measurement.reading));
  EXPECT_TRUE(std::holds_alternative<SonarPing>(same_instant[2].measurement.reading));
}

TEST_F(SensorSuiteTest, OneSensorDoesNotDisturbAnother) {
  SensorsConfig without_sonar = NoCamera();
  without_sonar.sonar.enabled = false;
  SensorsConfig quiet_depth = NoCamera();
  quiet_depth.depth.noise = false;
  const auto all = Select<ImuSample>(Collect(NoCamera(), 1, 2.0));
  for (const SensorsConfig& config : {without_sonar, quiet_depth}) {
    const auto imu = Select<ImuSample>(Collect(config, 1, 2.0));
    ASSERT_EQ(imu.size(), all.size());
    for (std::size_t i = 0; i < imu.size(); ++i) {
      EXPECT_EQ(imu[i].second.angular_rate, all[i].second.angular_rate);
      EXPECT_EQ(imu[i].second.specific_force, all[i].second.specific_force);
    }
  }
}

// A switch is the same as a rig without that effect, and does something.
TEST_F(SensorSuiteTest, EffectsAreOffWhereTheyAreSwitchedOff) {
  SensorsConfig config = NoCamera();
  config.imu_effects.quantisation = config.imu_effects.misalignment = false;
  config.depth_effects.offset = false;
  const auto all = Collect(NoCamera(), 1, 2.0);
  const auto switched = Collect(config, 1, 2.0);
  rig_.imu.gyro_resolution = rig_.imu.accel_resolution = 0.0;
  rig_.imu.gyro_misalignment = rig_.imu.accel_misalignment = 0.0;
  rig_.depth.offset_m = 0.0;
  const auto without = Collect(NoCamera(), 1, 2.0);
  const auto imu_all = Select<ImuSample>(all), imu_switched = Select<ImuSample>(switched),
             imu_without = Select<ImuSample>(without);
  ASSERT_EQ(imu_switched.size(), imu_without.size());
  for (std::size_t i = 0; i < imu_switched.size(); ++i) {
    EXPECT_EQ(imu_switched[i].second.angular_rate, imu_without[i].second.angular_rate);
    EXPECT_EQ(imu_switched[i].second.specific_force, imu_without[i].second.specific_force);
    EXPECT_NE(imu_switched[i].second.specific_force, imu_all[i].second.specific_force);
  }
  const auto depth_all = Select<DepthSample>(all), depth_switched = Select<DepthSample>(switched),
             depth_without = Select<DepthSample>(without);
  ASSERT_EQ(depth_switched.size(), depth_without.size());
  for (std::size_t i = 0; i < depth_switched.size(); ++i) {
    EXPECT_EQ(depth_switched[i].second.depth, depth_without[i].second.depth);
    EXPECT_NE(depth_switched[i].second.depth, depth_all[i].second.depth);
  }
}

TEST_F(SensorSuiteTest, NoiseIsOffWhereItIsSwitchedOff) {
  SensorsConfig config = NoCamera();
  config.imu.noise = config.sonar.noise = config.depth.noise = false;
  const auto one = Collect(config, 1, 1.0);
  const auto other = Collect(config, 99, 1.0);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (const auto* depth = std::get_if<DepthSample>(&one[i].measurement.reading)) {
      EXPECT_EQ(depth->depth, std::get<DepthSample>(other[i].measurement.reading).depth);
    }
    if (const auto* ping = std::get_if<SonarPing>(&one[i].measurement.reading)) {
      EXPECT_EQ(ping->range, std::get<SonarTruth>(one[i].truth).range);
    }
    if (const auto* imu = std::get_if<ImuSample>(&one[i].measurement.reading)) {
      EXPECT_EQ(imu->angular_rate, std::get<ImuSample>(other[i].measurement.reading).angular_rate);
    }
  }
}

TEST_F(SensorSuiteTest, ARigWithoutSonarHasNoPings) {
  rig_.sonar.rate_hz = 0.0;
  EXPECT_TRUE(Select<SonarPing>(Collect(NoCamera(), 1, 1.0)).empty());
}

}  // namespace
}  // namespace drydock::sim
