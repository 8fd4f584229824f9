#include "sensors_models/noise/imu_noise.h"

#include <cmath>
#include <map>

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

/// Squares of `change` in standard deviations, added up.
double Normalised(const Eigen::Vector3d& change, double sigma) {
  return change.squaredNorm() / (sigma * sigma);
}

// From the start, the bias has walked by walk^2 T after T seconds, at whatever T one looks; and
// what it walks from one look to the next is independent of before. Chi-square over 100 seeds, both
// triples and three axes: 600 degrees of freedom, of which 99.9 % lie within 492 and 721.
TEST(ImuNoise, BiasWalksAsItShould) {
  constexpr int kSeeds = 100;
  const ImuSheet sheet = Sheet();
  std::map<int, double> from_start = {{1, 0.0}, {10, 0.0}, {100, 0.0}, {500, 0.0}, {2000, 0.0}};
  std::map<int, double> from_last = from_start;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    ImuNoise noise(sheet, seed);
    const Eigen::Vector3d gyro_start = noise.gyro_bias(), accel_start = noise.accel_bias();
    Eigen::Vector3d gyro_last = gyro_start, accel_last = accel_start;
    int steps = 0;
    for (auto& [look, sum] : from_start) {
      const double since_start = std::sqrt(look / sheet.rate_hz);
      const double since_last = std::sqrt((look - steps) / sheet.rate_hz);
      for (; steps < look; ++steps) noise.Corrupt({});
      sum += Normalised(noise.gyro_bias() - gyro_start, sheet.gyro_bias_walk * since_start) +
             Normalised(noise.accel_bias() - accel_start, sheet.accel_bias_walk * since_start);
      from_last[look] +=
          Normalised(noise.gyro_bias() - gyro_last, sheet.gyro_bias_walk * since_last) +
          Normalised(noise.accel_bias() - accel_last, sheet.accel_bias_walk * since_last);
      gyro_last = noise.gyro_bias();
      accel_last = noise.accel_bias();
    }
  }
  for (const auto& chi_square : {from_start, from_last}) {
    for (const auto& [steps, sum] : chi_square) {
      EXPECT_GT(sum, 492.0) << steps;
      EXPECT_LT(sum, 721.0) << steps;
    }
  }
}

// As above, of the first bias.
TEST(ImuNoise, TurnOnBiasesHaveTheirSpread) {
  const ImuSheet sheet = Sheet();
  double chi_square = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ImuNoise noise(sheet, seed);
    chi_square += Normalised(noise.gyro_bias(), sheet.gyro_turn_on_bias) +
                  Normalised(noise.accel_bias(), sheet.accel_turn_on_bias);
  }
  EXPECT_GT(chi_square, 492.0);
  EXPECT_LT(chi_square, 721.0);
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
