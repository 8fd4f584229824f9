#include "estimator/svin2/preintegration/imu_preintegration.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/inertial/imu_integration.h"
#include "sensors_models/base/pose.h"
#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/support/numeric.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::MotionAt;
using testing::MotionSamples;
using Vector9d = Eigen::Matrix<double, 9, 1>;

constexpr std::int64_t kMs = 1'000'000;
const ImuBias kBias = {{0.02, -0.01, 0.03}, {0.1, -0.2, 0.05}};

ImuPreintegration Integrate(std::span<const TimedImuSample> samples, Time begin, Time end,
                            const ImuBias& bias = {}, const ImuNoiseModel& noise = {}) {
  const auto preintegration = ImuPreintegration::Over(samples, begin, end, bias, noise);
  if (!preintegration) throw std::runtime_error("no pre-integration");
  return *preintegration;
}

/// What the deltas should be between two states, by their definition.
ImuDelta TrueDelta(const NavState& i, const NavState& j) {
  const double T = (j.t - i.t).Seconds();
  const Eigen::Quaterniond q_iW = i.T_WI.q().conjugate();
  return {q_iW * (j.T_WI.p() - i.T_WI.p() - i.v_W * T - 0.5 * kGravity * T * T), q_iW * j.T_WI.q(),
          q_iW * (j.v_W - i.v_W - kGravity * T)};
}

/// a - b in the tangent space of deltas.
Vector9d Difference(const ImuDelta& a, const ImuDelta& b) {
  Vector9d difference;
  difference << a.p - b.p, LogSO3(a.q * b.q.conjugate()), a.v - b.v;
  return difference;
}

TEST(ImuPreintegration, ConstantReadingsHaveAClosedForm) {
  // Turning at w about z, the force f along x points along (cos wt, sin wt, 0).
  constexpr double kRate = 0.5, kForce = 2.0, kLength = 0.2;
  std::vector<TimedImuSample> samples;
  for (std::int64_t k = 0; k <= 200; ++k)
    samples.push_back({{k * kMs}, {{0, 0, kRate}, {kForce, 0, 0}}});
  const ImuDelta delta = Integrate(samples, {0}, {200 * kMs}).delta();
  const double angle = kRate * kLength;
  const Vector3d v = kForce / kRate * Vector3d(std::sin(angle), 1.0 - std::cos(angle), 0.0);
  const Vector3d p =
      kForce / (kRate * kRate) * Vector3d(1.0 - std::cos(angle), angle - std::sin(angle), 0.0);
  EXPECT_LT(LogSO3(delta.q * ExpSO3({0, 0, -angle})).norm(), 1e-14);
  // The trapezoidal rule is off by dt^2 / 12 of what the force's slope of 1 m/s^3 changes by: 0.1.
  // Position by dt^3 / 12 of the slope itself in each of the 200 steps.
  EXPECT_LT((delta.v - v).norm(), 1e-6 / 12.0 * 0.101);
  EXPECT_LT((delta.p - p).norm(), 1e-6 / 12.0 * 0.21);
}

TEST(ImuPreintegration, FollowsAKnownMotionToSecondOrder) {
  // Begins and ends between samples.
  const Time begin{1'003 * kMs}, end{1'517 * kMs};
  const ImuDelta truth = TrueDelta(MotionAt(begin), MotionAt(end));
  const auto error = [&](std::int64_t period_us) {
    const auto samples = MotionSamples(begin, end, {period_us * 1000}, kBias.gyro, kBias.accel);
    return Difference(Integrate(samples, begin, end, kBias).delta(), truth).norm();
  };
  // Forces change by some 2 m/s^3 in a second: 1e-4 / 12 * 2 m/s.
  EXPECT_LT(error(10'000), 2e-5);
  EXPECT_LT(error(100), 2e-9);
  EXPECT_NEAR(error(1'000) / error(500), 4.0, 0.4);
}

TEST(ImuPreintegration, AgreesWithDeadReckoning) {
  const Time begin{200 * kMs}, end{300 * kMs};
  const auto samples = MotionSamples(begin, end, {10 * kMs}, kBias.gyro, kBias.accel);
  NavState state = MotionAt(begin);
  state.gyro_bias = kBias.gyro;
  state.accel_bias = kBias.accel;
  const NavState start = state;
  for (std::size_t k = 0; k + 1 < samples.size() && samples[k].t < end; ++k) {
    state = IntegrateMidpoint(state, samples[k].sample, samples[k + 1].sample, samples[k + 1].t);
  }
  ASSERT_EQ(state.t, end);
  const ImuDelta delta = Integrate(samples, begin, end, kBias).delta();
  EXPECT_LT(Difference(delta, TrueDelta(start, state)).norm(), 1e-13);
}

ImuBias Moved(const ImuBias& bias, int axis, double by) {
  ImuBias moved = bias;
  (axis < 3 ? moved.gyro[axis] : moved.accel[axis - 3]) += by;
  return moved;
}

TEST(ImuPreintegration, BiasJacobianIsTheDerivativeOfTheDeltas) {
  const Time begin{103 * kMs}, end{608 * kMs};
  const auto samples = MotionSamples(begin, end, {10 * kMs});
  const ImuPreintegration here = Integrate(samples, begin, end, kBias);
  for (int axis = 0; axis < 6; ++axis) {
    const Vector9d numeric = drydock::testing::NumericDerivative(
        [&](double by) -> Vector9d {
          const ImuBias bias = Moved(kBias, axis, by);
          return Difference(Integrate(samples, begin, end, bias).delta(), here.delta());
        },
        0.0);
    EXPECT_LT((here.bias_jacobian().col(axis) - numeric).norm(), 1e-8) << axis;
  }
}

TEST(ImuPreintegration, DeltasFollowTheBiasToFirstOrder) {
  const Time begin{103 * kMs}, end{608 * kMs};
  const auto samples = MotionSamples(begin, end, {10 * kMs});
  const ImuPreintegration here = Integrate(samples, begin, end, kBias);
  const auto error = [&](double by) {
    ImuBias bias = kBias;
    bias.gyro += Vector3d(by, -by, by);
    bias.accel += Vector3d(by, by, -by);
    return Difference(here.DeltaAt(bias), here.IntegratedAt(bias).delta()).norm();
  };
  // What is left is of second order.
  EXPECT_NEAR(error(2e-3) / error(1e-3), 4.0, 0.1);
  EXPECT_LT(error(1e-4), 1e-8);
  EXPECT_EQ(error(0.0), 0.0);
}

TEST(ImuPreintegration, ReintegratesWhenTheGyroBiasTurnsItByATenthOfAMilliradian) {
  // Over half a second the limit is a change of 2e-4 rad/s, however it is split over the axes.
  const auto samples = MotionSamples({0}, {500 * kMs}, {10 * kMs});
  const ImuPreintegration here = Integrate(samples, {0}, {500 * kMs}, kBias);
  ImuBias bias = kBias;
  bias.gyro += Vector3d(1.2e-4, 0, -1.5e-4);
  bias.accel += Vector3d(1, 1, 1);
  EXPECT_FALSE(here.NeedsReintegration(bias));
  bias.gyro = kBias.gyro + Vector3d(1.4e-4, 0, -1.5e-4);
  EXPECT_TRUE(here.NeedsReintegration(bias));
  EXPECT_FALSE(here.IntegratedAt(bias).NeedsReintegration(bias));
}

TEST(ImuPreintegration, CovarianceAtRestGrowsAsTheTextbookSays) {
  // Without gravity or turning, velocity is a random walk, position its integral, and the biases'
  // walks come in by the third and fifth power of time.
  ImuNoiseModel noise;
  noise.gyro_noise_density = 0.01;
  noise.accel_noise_density = 0.02;
  noise.gyro_bias_walk = 0.03;
  noise.accel_bias_walk = 0.04;
  std::vector<TimedImuSample> samples;
  for (std::int64_t k = 0; k <= 1000; ++k) samples.push_back({{k * kMs}, {}});
  const double T = 1.0;
  const ImuCovariance P = Integrate(samples, {0}, {1000 * kMs}, {}, noise).covariance();
  const double accel = 4e-4, accel_walk = 1.6e-3, gyro = 1e-4, gyro_walk = 9e-4;
  EXPECT_NEAR(P(0, 0), accel * T / 3 + accel_walk * T / 20, 1e-6);
  EXPECT_NEAR(P(0, 6), accel * T / 2 + accel_walk * T / 8, 1e-6);
  EXPECT_NEAR(P(6, 6), accel * T + accel_walk * T / 3, 2e-6);
  EXPECT_NEAR(P(3, 3), gyro * T + gyro_walk * T / 3, 1e-6);
  EXPECT_NEAR(P(3, 9), -gyro_walk * T / 2, 1e-6);
  EXPECT_NEAR(P(9, 9), gyro_walk * T, 1e-12);
  EXPECT_NEAR(P(14, 14), accel_walk * T, 1e-12);
  EXPECT_NEAR(P(0, 1), 0.0, 1e-15);
}

TEST(ImuPreintegration, ASingleStepHasARegularCovariance) {
  const auto samples = MotionSamples({0}, {5 * kMs}, {10 * kMs});
  const ImuCovariance P = Integrate(samples, {0}, {5 * kMs}).covariance();
  EXPECT_EQ(P.llt().info(), Eigen::Success);
  // White noise over T: position T^3/3, velocity T, together T^2/2 of the density squared.
  EXPECT_NEAR(P(0, 0) / (7.1e-3 * 7.1e-3 * 1.25e-7 / 3.0), 1.0, 1e-3);
}

TEST(ImuPreintegration, GapsAndSaturationRaiseTheCovariance) {
  auto samples = MotionSamples({0}, {200 * kMs}, {10 * kMs});
  const ImuCovariance whole = Integrate(samples, {0}, {200 * kMs}).covariance();
  ImuNoiseModel limited;
  limited.accel_range = 5.0;  // Gravity alone is more.
  const ImuCovariance saturated = Integrate(samples, {0}, {200 * kMs}, {}, limited).covariance();
  EXPECT_NEAR(saturated(6, 6) / whole(6, 6), 1e4, 1e3);
  EXPECT_NEAR(saturated(3, 3) / whole(3, 3), 1.0, 1e-9);

  samples.erase(samples.begin() + 5, samples.begin() + 15);
  const ImuPreintegration gap = Integrate(samples, {0}, {200 * kMs});
  // 0.11 s of 0.2 s have 1e4 times the variance.
  EXPECT_NEAR(gap.covariance()(3, 3) / whole(3, 3), 0.55e4, 0.1e4);
  const ImuDelta truth = TrueDelta(MotionAt({0}), MotionAt({200 * kMs}));
  EXPECT_LT(Difference(gap.delta(), truth).norm(), 2e-3);
}

TEST(ImuPreintegration, OverNoTimeNothingHappens) {
  const auto samples = MotionSamples({0}, {20 * kMs}, {10 * kMs});
  const ImuPreintegration none = Integrate(samples, {7 * kMs}, {7 * kMs}, kBias);
  EXPECT_EQ(none.delta().p, Vector3d::Zero());
  EXPECT_EQ(none.delta().v, Vector3d::Zero());
  EXPECT_EQ(LogSO3(none.delta().q), Vector3d::Zero());
  EXPECT_EQ(none.covariance(), ImuCovariance::Zero());
}

TEST(ImuPreintegration, NothingBackwardsInTimeOrWithoutSamples) {
  const auto samples = MotionSamples({0}, {20 * kMs}, {10 * kMs});
  EXPECT_FALSE(ImuPreintegration::Over(samples, {7 * kMs}, {6 * kMs}, {}, {}));
  EXPECT_FALSE(ImuPreintegration::Over({}, {6 * kMs}, {7 * kMs}, {}, {}));
}

TEST(ImuPreintegration, RefusesNoiseOfZero) {
  ImuNoiseModel noise;
  noise.accel_bias_walk = 0.0;
  EXPECT_THROW(ImuPreintegration::Over({}, {0}, {kMs}, {}, noise), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
