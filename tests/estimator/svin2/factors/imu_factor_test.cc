#include "estimator/svin2/factors/imu_factor.h"

#include <Eigen/LU>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/factors/factor_check.h"
#include "tests/estimator/svin2/synthetic_motion.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;
using testing::MotionAt;
using testing::MotionSamples;

constexpr std::int64_t kMs = 1'000'000;
constexpr Time kBegin{1'003 * kMs}, kEnd{1'203 * kMs};
const ImuBias kBias = {{0.02, -0.01, 0.03}, {0.1, -0.2, 0.05}};

Blocks States(const Pose& T_i, const SpeedBias& s_i, const Pose& T_j, const SpeedBias& s_j) {
  return {Block(ToParameters(T_i)), Block(ToParameters(s_i)), Block(ToParameters(T_j)),
          Block(ToParameters(s_j))};
}

Blocks TrueStates(const ImuBias& bias = kBias) {
  const NavState i = MotionAt(kBegin), j = MotionAt(kEnd);
  return States(i.T_WI, {i.v_W, bias}, j.T_WI, {j.v_W, bias});
}

ImuPreintegration Preintegration(std::int64_t period_us, const ImuBias& at = kBias,
                                 const ImuNoiseModel& noise = {}) {
  const auto samples = MotionSamples(kBegin, kEnd, {period_us * 1000}, kBias.gyro, kBias.accel);
  return *ImuPreintegration::Over(samples, kBegin, kEnd, at, noise);
}

/// States some way off, and with them residuals that are not small.
Blocks WrongStates(const ImuBias& bias) {
  const NavState i = MotionAt(kBegin), j = MotionAt(kEnd);
  Vector6d off_i, off_j;
  off_i << 0.01, -0.02, 0.03, 0.02, -0.01, 0.03;
  off_j << -0.03, 0.01, 0.02, -0.3, 0.5, 0.4;
  SpeedBias s_j{j.v_W + Vector3d(0.1, 0.2, -0.1), kBias};
  s_j.bias.gyro += Vector3d(1e-3, 2e-3, 3e-3);
  s_j.bias.accel += Vector3d(0.01, -0.02, 0.03);
  return States(i.T_WI.BoxPlus(off_i), {i.v_W + Vector3d(-0.1, 0.1, 0.2), bias},
                j.T_WI.BoxPlus(off_j), s_j);
}

TEST(ImuFactor, VanishesOnTheTrueMotion) {
  // With samples every 20 us the trapezoidal rule is right to (2e-5 s)^2 / 12 times the change of
  // force, some 1e-11 m/s; this noise has standard deviations of 0.05 m to 0.4 rad over 0.2 s.
  ImuNoiseModel blunt;
  blunt.gyro_noise_density = blunt.accel_noise_density = 1.0;
  blunt.gyro_bias_walk = blunt.accel_bias_walk = 1.0;
  const ImuFactor factor(Preintegration(20, kBias, blunt));
  EXPECT_LT(testing::Residuals(factor, TrueStates()).norm(), 1e-9);
  // At the IMU's real rate and noise the trapezoidal rule costs a share of a standard deviation.
  EXPECT_LT(testing::Residuals(ImuFactor(Preintegration(10'000)), TrueStates()).norm(), 0.1);
}

TEST(ImuFactor, ValuesByHandAtRest) {
  // Level and at rest for 0.1 s; the second state is off by 2 mm along x, 0.01 rad about z, 0.03
  // m/s along y and has other biases.
  std::vector<TimedImuSample> samples;
  for (std::int64_t k = 0; k <= 10; ++k)
    samples.push_back({{k * 10 * kMs}, {Vector3d::Zero(), {0, 0, 9.81}}});
  const auto preintegration =
      *ImuPreintegration::Over(samples, {0}, {100 * kMs}, {}, ImuNoiseModel{});
  const SpeedBias after{{0, 0.03, 0}, {{0, 0, 1e-3}, {0.02, 0, 0}}};
  const Blocks states = States(Pose(), {}, Pose(ExpSO3({0, 0, 0.01}), {0.002, 0, 0}), after);
  Eigen::Matrix<double, 15, 1> e = Eigen::Matrix<double, 15, 1>::Zero();
  e[0] = 0.002;
  e[5] = 0.01;
  e[7] = 0.03;
  e[11] = 1e-3;
  e[12] = 0.02;
  const double expected = e.dot(preintegration.covariance().inverse() * e);
  const double squared = testing::Residuals(ImuFactor(preintegration), states).squaredNorm();
  EXPECT_NEAR(squared / expected, 1.0, 1e-6);
}

TEST(ImuFactor, IsTheSameWhereverTheWorldLooks) {
  // Yaw and position of both states are no one's business.
  const ImuFactor factor(Preintegration(10'000));
  const Blocks states = WrongStates(kBias);
  const Pose move(ExpSO3({0, 0, 1.2}), {10, -20, 30});
  Blocks moved = states;
  for (const std::size_t k : {0u, 2u})
    moved[k] = Block(ToParameters(move * FromParameters(states[k].data())));
  for (const std::size_t k : {1u, 3u}) {
    SpeedBias s = SpeedBiasFromParameters(states[k].data());
    s.v_W = move.q() * s.v_W;
    moved[k] = Block(ToParameters(s));
  }
  const Eigen::VectorXd e = testing::Residuals(factor, states);
  EXPECT_LT((testing::Residuals(factor, moved) - e).norm(), 1e-9 * e.norm());
}

TEST(ImuFactor, JacobiansMatchDifferences) {
  const ImuFactor factor(Preintegration(10'000));
  // Small steps, for the gyro's bias must stay within first order.
  EXPECT_LT(testing::WorstJacobianError(factor, TrueStates(), 1e-5), 1e-6);
  EXPECT_LT(testing::WorstJacobianError(factor, WrongStates(kBias), 1e-5), 1e-6);
}

TEST(ImuFactor, JacobiansMatchDifferencesAtAnotherBias) {
  ImuBias bias = kBias;
  bias.gyro += Vector3d(2e-4, -2e-4, 3e-4);  // 8e-5 rad over 0.2 s.
  bias.accel += Vector3d(0.1, 0.2, -0.1);
  const ImuFactor factor(Preintegration(10'000));
  ASSERT_FALSE(factor.preintegration().NeedsReintegration(bias));
  EXPECT_LT(testing::WorstJacobianError(factor, WrongStates(bias), 1e-5), 1e-6);
}

TEST(ImuFactor, IntegratesAnewWhereTheBiasIsFarOff) {
  // Integrated with no bias and asked at the true one, which turns it by 7 mrad: first order would
  // leave errors of some 1e-5 m/s.
  ImuNoiseModel blunt;
  blunt.gyro_noise_density = blunt.accel_noise_density = 1.0;
  blunt.gyro_bias_walk = blunt.accel_bias_walk = 1.0;
  const ImuFactor factor(Preintegration(20, {}, blunt));
  ASSERT_TRUE(factor.preintegration().NeedsReintegration(kBias));
  EXPECT_LT(testing::Residuals(factor, TrueStates()).norm(), 1e-9);
  const ImuFactor usual(Preintegration(10'000, {}));
  EXPECT_LT(testing::WorstJacobianError(usual, WrongStates(kBias), 1e-5), 1e-6);
}

TEST(ImuFactor, RefusesAnEmptyInterval) {
  const auto samples = MotionSamples(kBegin, kEnd, {10 * kMs});
  const auto none = ImuPreintegration::Over(samples, kBegin, kBegin, {}, {});
  ASSERT_TRUE(none);
  EXPECT_THROW(ImuFactor{*none}, std::logic_error);
}

TEST(ImuFactor, ComputesOnlyTheDerivativesAskedFor) {
  const ImuFactor factor(Preintegration(10'000));
  const Blocks states = TrueStates();
  Eigen::Matrix<double, 15, 1> residuals;
  Eigen::Matrix<double, 15, 9, Eigen::RowMajor> by_speed;
  double* jacobians[] = {nullptr, by_speed.data(), nullptr, nullptr};
  ASSERT_TRUE(factor.Evaluate(testing::Pointers(states).data(), residuals.data(), jacobians));
  EXPECT_EQ(Eigen::MatrixXd(by_speed), testing::TangentJacobians(factor, states)[1]);
}

}  // namespace
}  // namespace drydock::svin2
