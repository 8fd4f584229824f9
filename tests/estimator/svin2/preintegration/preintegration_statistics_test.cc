// The covariance against many draws of the noise that it describes.
#include <Eigen/Cholesky>
#include <cmath>

#include <gtest/gtest.h>

#include "estimator/svin2/preintegration/imu_preintegration.h"
#include "sensors_models/base/pose.h"
#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/synthetic_motion.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using Vector15d = Eigen::Matrix<double, 15, 1>;

constexpr int kDraws = 500;
constexpr Duration kPeriod{10'000'000};

Vector3d Draw(RandomStream& random, double sigma) {
  const double x = sigma * random.Gaussian();
  const double y = sigma * random.Gaussian();
  const double z = sigma * random.Gaussian();
  return {x, y, z};
}

/// Noise as the IMU's own model makes it: white of density / sqrt(dt), a walk of density sqrt(dt)
/// a step. Returns where the biases have come to at the last sample, gyro first.
Eigen::Matrix<double, 6, 1> AddNoise(RandomStream& random, const ImuNoiseModel& noise,
                                     std::vector<TimedImuSample>& samples) {
  const double root = std::sqrt(kPeriod.Seconds());
  Vector3d gyro_bias = Vector3d::Zero(), accel_bias = Vector3d::Zero();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (k > 0) {
      gyro_bias += Draw(random, noise.gyro_bias_walk * root);
      accel_bias += Draw(random, noise.accel_bias_walk * root);
    }
    ImuSample& sample = samples[k].sample;
    sample.angular_rate += gyro_bias + Draw(random, noise.gyro_noise_density / root);
    sample.specific_force += accel_bias + Draw(random, noise.accel_noise_density / root);
  }
  Eigen::Matrix<double, 6, 1> biases;
  biases << gyro_bias, accel_bias;
  return biases;
}

/// Mean of e' P^-1 e over the draws, by degree of freedom. The first `dof` errors of 15 count.
double MeanNees(const ImuNoiseModel& noise, Time end, int dof) {
  const Time begin{0};
  const auto exact = testing::MotionSamples(begin, end + Duration{-1}, kPeriod);
  const ImuDelta truth = ImuPreintegration::Over(exact, begin, end, {}, noise)->delta();
  double sum = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    RandomStream random(static_cast<std::uint64_t>(draw), "preintegration");
    auto samples = exact;
    const Eigen::Matrix<double, 6, 1> biases = AddNoise(random, noise, samples);
    const auto noisy = ImuPreintegration::Over(samples, begin, end, {}, noise);
    const ImuDelta& delta = noisy->delta();
    Vector15d error;
    error << truth.p - delta.p, LogSO3(truth.q * delta.q.conjugate()), truth.v - delta.v, biases;
    const Eigen::MatrixXd P = noisy->covariance().topLeftCorner(dof, dof);
    sum += error.head(dof).dot(P.llt().solve(error.head(dof)));
  }
  return sum / (kDraws * dof);
}

// A mean over 500 draws of 9 (15) degrees of freedom has a standard deviation of sqrt(2 / 4500) =
// 0.021 (0.016). The trapezoidal rule halves the weight of the samples at the ends, which the
// covariance leaves out so that neighbouring intervals add up: one part in the number of steps.
TEST(PreintegrationStatistics, WhiteNoiseIsCovered) {
  ImuNoiseModel noise;
  noise.gyro_bias_walk = 1e-9;
  noise.accel_bias_walk = 1e-9;
  EXPECT_NEAR(MeanNees(noise, {1'000'000'000}, 9), 0.99, 0.065);
}

TEST(PreintegrationStatistics, WalkingBiasesAreCoveredWithTheirCorrelations) {
  ImuNoiseModel noise;
  // As strong after a second as the white noise.
  noise.gyro_bias_walk = 3e-3;
  noise.accel_bias_walk = 1.5e-2;
  EXPECT_NEAR(MeanNees(noise, {1'000'000'000}, 15), 0.99, 0.055);
}

TEST(PreintegrationStatistics, OverAFrameIntervalTooWithinTheEndsShare) {
  ImuNoiseModel noise;
  noise.gyro_bias_walk = 1e-9;
  noise.accel_bias_walk = 1e-9;
  const double nees = MeanNees(noise, {70'000'000}, 9);
  EXPECT_GT(nees, 0.75);
  EXPECT_LT(nees, 1.06);
}

}  // namespace
}  // namespace drydock::svin2
