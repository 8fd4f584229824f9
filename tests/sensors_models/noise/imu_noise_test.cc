#include "sensors_models/noise/imu_noise.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock {
namespace {

ImuSheet Sheet() {
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.gyro_noise_density = 1.6e-4;
  sheet.accel_noise_density = 7.14e-4;
  sheet.gyro_bias_walk = 1.65e-6;
  sheet.accel_bias_walk = 2.87e-5;
  sheet.gyro_turn_on_bias = 8.7e-4;
  sheet.accel_turn_on_bias = 1.96e-2;
  return sheet;
}

TEST(ImuNoise, ASheetOfZerosChangesNothing) {
  ImuSheet sheet;
  sheet.rate_hz = 100.0;
  ImuNoise noise(sheet, 1);
  const ImuSample truth{{0.1, -0.2, 0.3}, {1.0, 2.0, 9.8}};
  for (int i = 0; i < 10; ++i) {
    const ImuSample sample = noise.Corrupt(truth);
    EXPECT_EQ(sample.angular_rate, truth.angular_rate);
    EXPECT_EQ(sample.specific_force, truth.specific_force);
  }
}

TEST(ImuNoise, WhiteNoiseHasItsDensity) {
  ImuSheet sheet = Sheet();
  sheet.gyro_bias_walk = sheet.gyro_turn_on_bias = 0.0;
  ImuNoise noise(sheet, 5);
  double squares = 0.0;
  constexpr int kSamples = 40'000;
  for (int i = 0; i < kSamples; ++i) squares += noise.Corrupt({}).angular_rate.squaredNorm();
  // 120'000 numbers: the standard deviation is known to 0.2 %.
  EXPECT_NEAR(std::sqrt(squares / (3.0 * kSamples)), 1.6e-4 * 10.0, 0.01 * 1.6e-3);
}

// The bias after T seconds has variance turn_on^2 + walk^2 T; chi-square over 100 seeds and three
// axes.
TEST(ImuNoise, BiasWalksAsItShould) {
  double chi_square = 0.0;
  constexpr int kSeeds = 100, kSteps = 2000;
  for (int seed = 0; seed < kSeeds; ++seed) {
    ImuNoise noise(Sheet(), static_cast<std::uint64_t>(seed));
    const Eigen::Vector3d start = noise.accel_bias();
    for (int i = 0; i < kSteps; ++i) noise.Corrupt({});
    const double variance = 2.87e-5 * 2.87e-5 * kSteps / 100.0;
    chi_square += (noise.accel_bias() - start).squaredNorm() / variance;
  }
  // 300 degrees of freedom: 99.9 % lie within 225 and 387.
  EXPECT_GT(chi_square, 225.0);
  EXPECT_LT(chi_square, 387.0);
}

TEST(ImuNoise, TurnOnBiasesDifferBySeedAndAxis) {
  const ImuNoise one(Sheet(), 1), again(Sheet(), 1), two(Sheet(), 2);
  EXPECT_EQ(one.gyro_bias(), again.gyro_bias());
  EXPECT_NE(one.gyro_bias(), two.gyro_bias());
  EXPECT_NE(one.gyro_bias().x(), one.gyro_bias().y());
  EXPECT_GT(one.accel_bias().norm(), 0.0);
}

}  // namespace
}  // namespace drydock
