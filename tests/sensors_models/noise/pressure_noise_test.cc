#include "sensors_models/noise/pressure_noise.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock {
namespace {

DepthSheet Sheet() {
  DepthSheet sheet;
  sheet.rate_hz = 10.0;
  sheet.noise_m = 0.004;
  sheet.offset_m = 0.5;
  sheet.lag_s = 0.3;
  sheet.resolution_m = 0.01;
  return sheet;
}

constexpr PressureEffects kNone{
    .white_noise = false, .offset = false, .lag = false, .quantisation = false};

TEST(PressureNoise, WithEverythingOffItSaysTheTruth) {
  const DepthSheet sheet = KeepEffects(Sheet(), kNone);
  EXPECT_EQ(sheet.lag_s, 0.0);
  PressureNoise noise(sheet, 1);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(noise.Corrupt(0.1 * k), 0.1 * k);
}

TEST(PressureNoise, QuantisationByHand) {
  PressureEffects effects = kNone;
  effects.quantisation = true;
  PressureNoise noise(KeepEffects(Sheet(), effects), 1);
  EXPECT_DOUBLE_EQ(noise.Corrupt(3.1449), 3.14);
  EXPECT_DOUBLE_EQ(noise.Corrupt(3.1451), 3.15);
  EXPECT_DOUBLE_EQ(noise.Corrupt(-0.006), -0.01);
}

TEST(PressureNoise, TheOffsetIsConstantInADive) {
  PressureEffects effects = kNone;
  effects.offset = true;
  PressureNoise noise(KeepEffects(Sheet(), effects), 4);
  EXPECT_EQ(noise.offset(), 0.5 * RandomStream(4, "pressure0/offset").GaussianAt(0));
  for (int k = 0; k < 100; ++k) EXPECT_EQ(noise.Corrupt(0.1 * k), 0.1 * k + noise.offset());
}

// 100 seeds: 99.9 % of chi-square with 100 degrees of freedom lie within 60 and 153.
TEST(PressureNoise, TheOffsetHasItsSpreadOverSeeds) {
  double chi_square = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    chi_square += std::pow(PressureNoise(Sheet(), seed).offset() / 0.5, 2.0);
  }
  EXPECT_GT(chi_square, 60.0);
  EXPECT_LT(chi_square, 153.0);
}

TEST(PressureNoise, WhiteNoiseHasItsSize) {
  PressureEffects effects = kNone;
  effects.white_noise = true;
  PressureNoise noise(KeepEffects(Sheet(), effects), 1);
  double squares = 0.0;
  constexpr int kSamples = 20'000;
  for (int k = 0; k < kSamples; ++k) squares += std::pow(noise.Corrupt(5.0) - 5.0, 2.0);
  // The standard deviation is known to 0.5 %.
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.004, 0.02 * 0.004);
}

TEST(PressureNoise, EachSwitchTakesAwayItsOwnAndNothingElse) {
  for (unsigned choice = 0; choice < 8; ++choice) {
    const auto on = [&](unsigned bit) { return ((choice >> bit) & 1U) != 0; };
    PressureNoise noise(KeepEffects(Sheet(), {on(0), on(1), true, on(2)}), 3);
    const RandomStream white(3, "pressure0/white"), offset(3, "pressure0/offset");
    for (int k = 0; k < 100; ++k) {
      double expected = 0.07 * k;
      if (on(0)) expected += 0.004 * white.GaussianAt(static_cast<std::uint64_t>(k));
      if (on(1)) expected += 0.5 * offset.GaussianAt(0);
      if (on(2)) expected = 0.01 * std::round(expected / 0.01);
      ASSERT_NEAR(noise.Corrupt(0.07 * k), expected, 1e-12) << choice << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace drydock
