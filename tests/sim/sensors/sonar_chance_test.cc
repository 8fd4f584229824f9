// What chance does to the sonar's pings, effect by effect.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/models/sonar_model.h"
#include "tests/sim/sensors/sonar_support.h"

namespace drydock::sim {
namespace {

/// Everything that chance does, as strong as in the SVIn2 rig or stronger.
SonarSheet NoisySheet() {
  SonarSheet sheet = PlainEchoSheet();
  sheet.range_noise_m = 0.01;
  sheet.absorption_db_m = 1.3;
  sheet.speckle_looks = 3;
  sheet.noise_floor = 0.03;
  sheet.dropout_probability = 0.1;
  return sheet;
}

SonarEffects NoChance() {
  SonarEffects effects;
  effects.speckle = effects.noise_floor = effects.dropouts = effects.white_noise = false;
  effects.profiles = true;
  return effects;
}

void ExpectSame(const SonarPing& a, const SonarPing& b) {
  EXPECT_EQ(a.range, b.range);
  EXPECT_EQ(a.intensity, b.intensity);
  EXPECT_EQ(a.first_range, b.first_range);
  EXPECT_EQ(a.profile, b.profile);
}

TEST(SonarChance, EachEffectCanBeSwitchedOff) {
  const SonarBench bench(WallAt(3.3));
  for (const SonarPing& ping : bench.Pings(50, NoisySheet(), NoChance())) {
    ExpectSame(ping, bench.Ping(NoisySheet(), NoChance()));
    EXPECT_NEAR(ping.range, 3.3, 0.5 * kBinLength);
  }
  // Each alone changes something.
  for (bool SonarEffects::*effect : {&SonarEffects::speckle, &SonarEffects::noise_floor,
                                     &SonarEffects::dropouts, &SonarEffects::white_noise}) {
    SonarEffects one = NoChance();
    one.*effect = true;
    const std::vector<SonarPing> pings = bench.Pings(50, NoisySheet(), one);
    EXPECT_TRUE(std::any_of(pings.begin(), pings.end(), [&](const SonarPing& ping) {
      return ping.profile != pings.front().profile;
    }));
  }
}

// At an incidence of 80 degrees the axis alone brings back cos(80 deg) = 0.17 of full scale, so
// that nothing saturates: of three looks the energy has mean 0.17 and a relative variance of 1/3.
TEST(SonarChance, SpeckleMultipliesTheEnergy) {
  SonarSheet sheet = NoisySheet();
  sheet.absorption_db_m = 0.0;
  sheet.intensity_floor = 0.0;
  SonarEffects effects = NoChance();
  effects.speckle = true;
  effects.quantisation = effects.footprint = false;
  const SonarBench bench(WallAt(1.0));
  const double phi = 80.0 * std::numbers::pi / 180.0;
  double mean = 0.0, square = 0.0;
  constexpr int kPings = 10'000;
  for (const SonarPing& ping : bench.Pings(kPings, sheet, effects, phi)) {
    const double factor = ping.intensity * ping.intensity / std::cos(phi);
    mean += factor / kPings;
    square += factor * factor / kPings;
  }
  // Standard errors: sqrt(1/3)/100 = 0.006, and for the variance about 0.008.
  EXPECT_NEAR(mean, 1.0, 0.03);
  EXPECT_NEAR(square - mean * mean, 1.0 / 3.0, 0.04);
}

// In open water only the receiver's noise is left. Its mean energy at the end of the reach is
// noise_floor^2, and a quarter of that half way. The mean of 3000 pings x 20 bins of an exponential
// strays by 0.4 %; 8 bits add 1/(12 x 255^2), which is 1e-4 of the larger.
TEST(SonarChance, NoiseFloorGrowsWithRange) {
  SonarSheet sheet = NoisySheet();
  sheet.noise_floor = 0.1;
  SonarEffects effects = NoChance();
  effects.noise_floor = true;
  const SonarBench bench(WallAt(50.0));
  std::vector<double> mean(255, 0.0);
  constexpr int kPings = 3000;
  for (const SonarPing& ping : bench.Pings(kPings, sheet, effects)) {
    const std::vector<double> energies = Energies(ping);
    for (std::size_t bin = 0; bin < 255; ++bin) mean[bin] += energies[bin] / kPings;
  }
  double outer = 0.0, middle = 0.0;
  for (std::size_t i = 0; i < 20; ++i) {
    outer += mean[235 + i] / 20.0;
    middle += mean[118 + i] / 20.0;
  }
  EXPECT_NEAR(outer, 0.01 * std::pow(245.0 / 255.0, 2), 3e-4);
  EXPECT_NEAR(middle, 0.01 * std::pow(128.0 / 255.0, 2), 1e-4);
  for (std::size_t bin = 0; bin < 5; ++bin) EXPECT_EQ(mean[bin], 0.0) << "nearer than the minimum";
}

// With the SVIn2 rig's floor, noise passes for an echo far out only: P(amplitude > floor) is
// exp(-(floor / noise)^2), at 6 m exp(-4) a bin, at 3 m exp(-16).
TEST(SonarChance, FalseEchoesAreFar) {
  SonarSheet sheet = NoisySheet();
  sheet.noise_floor = 0.02;
  SonarEffects effects = NoChance();
  effects.noise_floor = true;
  int far = 0;
  for (const SonarPing& ping : SonarBench(WallAt(50.0)).Pings(2000, sheet, effects)) {
    EXPECT_TRUE(ping.range == 0.0 || ping.range > 3.0);
    far += ping.range > 4.5 ? 1 : 0;
  }
  EXPECT_GT(far, 200);
}

// Binomial: 5000 pings at 10 % lose 500, give or take sqrt(5000 0.1 0.9) = 21.
TEST(SonarChance, LostPingsAreEmptyAndShiftNothing) {
  const SonarBench bench(WallAt(2.01));
  SonarEffects effects;
  effects.profiles = true;
  const std::vector<SonarPing> some_lost = bench.Pings(5000, NoisySheet(), effects);
  effects.dropouts = false;
  const std::vector<SonarPing> none_lost = bench.Pings(5000, NoisySheet(), effects);
  int lost = 0;
  for (std::size_t k = 0; k < some_lost.size(); ++k) {
    if (some_lost[k].range > 0.0) {
      ExpectSame(some_lost[k], none_lost[k]);
      continue;
    }
    ++lost;
    EXPECT_EQ(some_lost[k].intensity, 0.0);
    EXPECT_EQ(some_lost[k].first_range, 0.0);
    EXPECT_EQ(some_lost[k].profile, std::vector<std::uint8_t>(255, 0));
    EXPECT_NEAR(none_lost[k].range, 2.01, 0.07) << "seven sigma: it was not for want of an echo";
  }
  EXPECT_NEAR(lost, 500, 5 * 21);
}

// With bins off and nothing else, it is the axis plus white noise, as from a sheet without bins.
TEST(SonarChance, WhiteNoiseMovesThePingAsAWhole) {
  SonarEffects effects = NoChance();
  effects.white_noise = true;
  effects.quantisation = effects.footprint = false;
  SonarSheet without_bins = NoisySheet();
  without_bins.bins = 0;
  const SonarBench bench(WallAt(2.01));
  const std::vector<SonarPing> echoes = bench.Pings(200, NoisySheet(), effects);
  const std::vector<SonarPing> ranges = bench.Pings(200, without_bins, effects);
  double squares = 0.0;
  for (std::size_t k = 0; k < 200; ++k) {
    EXPECT_NEAR(echoes[k].range, ranges[k].range, 1e-12);
    squares += std::pow(echoes[k].range - 2.01, 2) / 200.0;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.01, 0.0025);
}

TEST(SonarChance, RangesHaveTheSigmaThatTheModelSays) {
  SonarSheet sheet = NoisySheet();
  EXPECT_NEAR(SonarRangeSigma(sheet), std::sqrt(1e-4 + kBinLength * kBinLength / 12.0), 1e-12);
  SonarEffects effects = NoChance();
  effects.white_noise = true;
  // Four walls at different places within a bin, so that the rounding is even.
  double squares = 0.0;
  for (const double part : {0.125, 0.375, 0.625, 0.875}) {
    const double range = (85.0 + part) * kBinLength;
    for (const SonarPing& ping : SonarBench(WallAt(range)).Pings(2000, sheet, effects)) {
      squares += std::pow(ping.range - range, 2) / 8000.0;
    }
  }
  EXPECT_NEAR(std::sqrt(squares) / SonarRangeSigma(sheet), 1.0, 0.03);
}

TEST(SonarChance, RoundedAmplitudesHaveEightBits) {
  SonarEffects effects;
  effects.profiles = true;
  const SonarBench bench(WallAt(2.01));
  for (const SonarPing& ping : bench.Pings(100, NoisySheet(), effects)) {
    const double level = 255.0 * ping.intensity;
    EXPECT_NEAR(level, std::round(level), 1e-9);
    if (ping.range == 0.0) continue;
    const auto bin = static_cast<std::size_t>(ping.range / kBinLength);
    EXPECT_EQ(ping.profile[bin], std::lround(level));
    EXPECT_EQ(ping.profile[bin], *std::max_element(ping.profile.begin(), ping.profile.end()));
  }
}

TEST(SonarChance, TheSeedDecides) {
  const SonarBench bench(WallAt(2.01));
  SonarEffects effects;
  effects.profiles = true;
  const auto one = bench.Pings(50, NoisySheet(), effects, 0.0, 1);
  const auto same = bench.Pings(50, NoisySheet(), effects, 0.0, 1);
  const auto other = bench.Pings(50, NoisySheet(), effects, 0.0, 2);
  for (std::size_t k = 0; k < 50; ++k) ExpectSame(one[k], same[k]);
  EXPECT_NE(one[1].profile, other[1].profile);
}

}  // namespace
}  // namespace drydock::sim
