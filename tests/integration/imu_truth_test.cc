// The simulated IMU against the truth that it comes from, by way of the estimator's integrator.
#include <gtest/gtest.h>

#include "estimator/inertial/imu_integration.h"
#include "scenarios/runner/scenario.h"
#include "sensors_models/base/resources.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/imu.h"

namespace drydock {
namespace {

TEST(ImuTruth, NoiseFreeDeadReckoningOfTheBusPathEndsOnTheTruth) {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml");
  for (const std::uint64_t seed : {1, 2, 3}) {
    const sim::SplineMotion motion(scenario.motion, seed);
    constexpr double kRate = 200.0;  // [Hz]
    const sim::MotionState start = motion.At(Time{});
    NavState state{Time{}, start.T_WI, start.v_W, {}, {}};
    ImuSample before = sim::IdealImu(start);
    for (std::int64_t k = 1; k <= 60 * 200; ++k) {
      const Time t = SampleTime(Time{}, k, kRate);
      const ImuSample sample = sim::IdealImu(motion.At(t));
      state = IntegrateMidpoint(state, before, sample, t);
      before = sample;
    }
    const sim::MotionState truth = motion.At(state.t);
    const double position_error = (state.T_WI.p() - truth.T_WI.p()).norm();
    std::printf("seed %d: %.2f mm after 60 s\n", static_cast<int>(seed), 1e3 * position_error);
    EXPECT_LT(position_error, 0.02);
    EXPECT_LT((state.v_W - truth.v_W).norm(), 2e-3);
    EXPECT_LT(LogSO3(state.T_WI.q() * truth.T_WI.q().conjugate()).norm(), 1e-4);
  }
}

TEST(ImuTruth, TheBusPathIsSwumAsItShould) {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml");
  sim::MotionConfig config = scenario.motion;
  config.sway = {};
  const sim::SplineMotion motion(config, 1);
  double length = 0.0;
  const double end = motion.End().Seconds();
  for (double t = 0.0; t < end; t += 0.01) {
    const sim::MotionState state = motion.At(Time::FromSeconds(t));
    length += 0.01 * state.v_W.norm();
    if (t > 8.0 && t < end - 8.0) {
      EXPECT_GT(state.v_W.norm(), 0.38) << t;
      EXPECT_LT(state.v_W.norm(), 0.52) << t;
    }
    EXPECT_LT(state.w_I.norm(), 0.6) << t;
  }
  std::printf("%.2f m in %.1f s\n", length, end);
  EXPECT_NEAR(length, 53.0, 0.5);
}

}  // namespace
}  // namespace drydock
