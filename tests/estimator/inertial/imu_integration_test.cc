#include "estimator/inertial/imu_integration.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(ImuIntegration, StaysAtRest) {
  const ImuSample rest{{0, 0, 0}, {0, 0, 9.81}};
  NavState state;
  for (std::int64_t k = 1; k <= 1000; ++k)
    state = IntegrateMidpoint(state, rest, rest, {k * 5'000'000});
  EXPECT_LT(state.T_WI.p().norm(), 1e-12);
  EXPECT_LT(state.v_W.norm(), 1e-12);
}

TEST(ImuIntegration, TakesBiasesOff) {
  NavState state;
  state.gyro_bias = {0.1, -0.2, 0.3};
  state.accel_bias = {0.5, 0.6, -0.7};
  const ImuSample rest{state.gyro_bias, Eigen::Vector3d(0, 0, 9.81) + state.accel_bias};
  for (std::int64_t k = 1; k <= 200; ++k)
    state = IntegrateMidpoint(state, rest, rest, {k * 5'000'000});
  EXPECT_LT(state.T_WI.p().norm(), 1e-12);
}

// A circle has a closed form: after one turn it is back, to third order in the step.
TEST(ImuIntegration, ClosesACircle) {
  constexpr double kRate = 0.5, kRadius = 2.0;
  const ImuSample sample{{0, 0, kRate}, {0, kRate * kRate * kRadius, 9.81}};
  const auto error = [&](int steps) {
    NavState state;
    state.v_W = {kRate * kRadius, 0, 0};
    const double period = 2.0 * 3.14159265358979 / kRate;
    for (int k = 1; k <= steps; ++k) {
      state = IntegrateMidpoint(state, sample, sample, Time::FromSeconds(period * k / steps));
    }
    return state.T_WI.p().norm();
  };
  EXPECT_LT(error(2500), 1e-4);
  // Halving the step divides the error by four.
  EXPECT_NEAR(error(200) / error(400), 4.0, 0.5);
}

}  // namespace
}  // namespace drydock
