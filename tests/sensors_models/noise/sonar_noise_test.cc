#include "sensors_models/noise/sonar_noise.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace drydock {
namespace {

SonarSheet Sheet() {
  SonarSheet sheet;
  sheet.bins = 100;
  sheet.range_noise_m = 0.01;
  sheet.speckle_looks = 1;
  sheet.dropout_probability = 0.05;
  return sheet;
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments MomentsOf(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  Moments moments;
  for (const double v : values) moments.mean += v / n;
  for (const double v : values) moments.variance += (v - moments.mean) * (v - moments.mean) / n;
  return moments;
}

// The mean of `looks` exponentials: mean 1, variance 1/looks. Of 200,000 numbers the mean strays by
// 1/sqrt(200,000 looks) < 0.0023, the variance by its sqrt(8/looks^2 + ...)/sqrt(200,000) < 0.0064;
// bounds are five times that.
TEST(SonarNoise, SpeckleHasMeanOneAndVarianceOneOverLooks) {
  for (const int looks : {1, 3, 8}) {
    SonarSheet sheet = Sheet();
    sheet.speckle_looks = looks;
    const SonarNoise noise(sheet, 1);
    std::vector<double> factors;
    for (std::uint64_t ping = 0; ping < 2000; ++ping) {
      for (std::size_t bin = 0; bin < 100; ++bin) factors.push_back(noise.Speckle(ping, bin));
    }
    const Moments moments = MomentsOf(factors);
    EXPECT_NEAR(moments.mean, 1.0, 0.012);
    EXPECT_NEAR(moments.variance * looks, 1.0, 0.032) << looks;
  }
}

// A single look is exponential: e^-x of the factors are above x.
TEST(SonarNoise, OneLookIsExponential) {
  const SonarNoise noise(Sheet(), 1);
  int above_one = 0, above_three = 0;
  for (std::uint64_t ping = 0; ping < 1000; ++ping) {
    for (std::size_t bin = 0; bin < 100; ++bin) {
      above_one += noise.Speckle(ping, bin) > 1.0 ? 1 : 0;
      above_three += noise.Speckle(ping, bin) > 3.0 ? 1 : 0;
    }
  }
  // Binomial: sqrt(100,000 p (1 - p)) is 153 and 69.
  EXPECT_NEAR(above_one, 1e5 * std::exp(-1.0), 5 * 153);
  EXPECT_NEAR(above_three, 1e5 * std::exp(-3.0), 5 * 69);
}

// Binomial: 20,000 pings at 5 % lose 1000, give or take sqrt(20,000 0.05 0.95) = 31.
TEST(SonarNoise, PingsAreLostAtTheirRate) {
  const SonarNoise noise(Sheet(), 7);
  int lost = 0;
  for (std::uint64_t ping = 0; ping < 20'000; ++ping) lost += noise.IsLost(ping) ? 1 : 0;
  EXPECT_NEAR(lost, 1000, 5 * 31);
}

TEST(SonarNoise, RangeErrorsAndReceiverNoiseHaveTheirSize) {
  const SonarNoise noise(Sheet(), 3);
  std::vector<double> ranges, energies;
  for (std::uint64_t ping = 0; ping < 20'000; ++ping) {
    ranges.push_back(noise.RangeError(ping));
    energies.push_back(noise.ReceiverNoise(ping, ping % 100));
  }
  // Standard errors: 0.01/sqrt(20,000) = 7e-5, and 0.5 % and 0.7 % of a standard deviation.
  EXPECT_NEAR(MomentsOf(ranges).mean, 0.0, 3.5e-4);
  EXPECT_NEAR(std::sqrt(MomentsOf(ranges).variance), 0.01, 0.01 * 0.025);
  EXPECT_NEAR(MomentsOf(energies).mean, 1.0, 0.035);
}

TEST(SonarNoise, EffectsAtZeroDoNothing) {
  const SonarNoise noise(SonarSheet{}, 3);
  for (std::uint64_t ping = 0; ping < 1000; ++ping) {
    EXPECT_FALSE(noise.IsLost(ping));
    EXPECT_EQ(noise.RangeError(ping), 0.0);
    EXPECT_EQ(noise.Speckle(ping, 3), 1.0);
  }
}

// Streams are named: another setting of one effect leaves the numbers of the others alone, and
// every number can be had without the ones before it.
TEST(SonarNoise, EffectsDoNotDisturbEachOther) {
  SonarSheet other = Sheet();
  other.dropout_probability = 0.5;
  other.range_noise_m = 0.02;
  const SonarNoise a(Sheet(), 1), b(other, 1), c(Sheet(), 2);
  EXPECT_EQ(a.Speckle(77, 5), b.Speckle(77, 5));
  EXPECT_EQ(a.ReceiverNoise(77, 5), b.ReceiverNoise(77, 5));
  EXPECT_EQ(2.0 * a.RangeError(77), b.RangeError(77));
  EXPECT_NE(a.Speckle(77, 5), a.ReceiverNoise(77, 5));
  EXPECT_NE(a.Speckle(77, 5), a.Speckle(77, 6));
  EXPECT_NE(a.Speckle(77, 5), c.Speckle(77, 5));
  for (std::uint64_t ping = 0; ping < 1000; ++ping) {
    EXPECT_LE(a.IsLost(ping), b.IsLost(ping)) << "whoever is lost at 5 % is lost at 50 %";
  }
}

}  // namespace
}  // namespace drydock
