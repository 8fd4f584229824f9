#include "sim/sensors/imu.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/sensors/still_motion.h"

namespace drydock::sim {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Imu, ReadsGravityUpwardsAtRest) {
  const ImuSample level = IdealImu(StillMotion(Pose::Identity()).At(Time{}));
  EXPECT_LT((level.specific_force - Eigen::Vector3d(0, 0, 9.81)).norm(), 1e-12);
  // Nose down by 30 degrees: the support, straight up, has a part against the x axis.
  const ImuSample tilted =
      IdealImu(StillMotion(Pose(FromYawPitchRoll(1.0, kPi / 6.0, 0.0), {0, 0, 0})).At(Time{}));
  EXPECT_LT((tilted.specific_force - 9.81 * Eigen::Vector3d(-0.5, 0, std::sqrt(0.75))).norm(),
            1e-12);
}

// A circle solved by hand: radius 2 m, 0.5 rad/s, nose along the path.
TEST(Imu, ReadsTheCentripetalForceOnACircle) {
  MotionState state;
  state.T_WI = Pose(FromYawPitchRoll(kPi / 2.0, 0.0, 0.0), {2, 0, 0});
  state.v_W = {0, 1, 0};
  state.a_W = {-0.5, 0, 0};
  state.w_I = {0, 0, 0.5};
  const ImuSample sample = IdealImu(state);
  EXPECT_LT((sample.angular_rate - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-12);
  EXPECT_LT((sample.specific_force - Eigen::Vector3d(0, 0.5, 9.81)).norm(),
            1e-12);  // Inwards is to the left.
}

TEST(Imu, FiresOnTheGridAndTellsItsBiases) {
  const StillMotion motion(Pose::Identity());
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.gyro_turn_on_bias = 1e-3;
  sheet.accel_turn_on_bias = 1e-2;
  Imu imu(motion, sheet, true, 3);
  for (int k = 0; k < 5; ++k) {
    const Observation observation = imu.Observe();
    EXPECT_EQ(observation.measurement.t.ns, k * 10'000'000);
    const auto& truth = std::get<ImuTruth>(observation.truth);
    const auto& sample = std::get<ImuSample>(observation.measurement.reading);
    EXPECT_LT((sample.angular_rate - truth.gyro_bias).norm(), 1e-15);
    EXPECT_LT((sample.specific_force - truth.accel_bias - Eigen::Vector3d(0, 0, 9.81)).norm(),
              1e-12);
  }
}

// What it says of the truth stays the biases, whatever else is wrong.
TEST(Imu, TheTruthIsItsBiasesUnderAllErrors) {
  const StillMotion motion(Pose::Identity());
  ImuSheet sheet = LoadRig(FindRig("svin2_v3")).imu;
  Imu with_all(motion, sheet, true, 3);
  const ImuEffects bias_only{.white_noise = false,
                             .scale_error = false,
                             .misalignment = false,
                             .saturation = false,
                             .quantisation = false};
  Imu with_biases(motion, KeepEffects(sheet, bias_only), true, 3);
  for (int k = 0; k < 100; ++k) {
    const Observation all = with_all.Observe(), biases = with_biases.Observe();
    const auto& truth = std::get<ImuTruth>(all.truth);
    const auto& sample = std::get<ImuSample>(biases.measurement.reading);
    EXPECT_LT((sample.angular_rate - truth.gyro_bias).norm(), 1e-15);
    EXPECT_LT((sample.specific_force - truth.accel_bias - Eigen::Vector3d(0, 0, 9.81)).norm(),
              1e-12);
  }
}

}  // namespace
}  // namespace drydock::sim
