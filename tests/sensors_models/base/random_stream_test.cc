#include "sensors_models/base/random_stream.h"

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace drydock {
namespace {

// From an independent implementation in Python that gives Random123's known answers for Philox
// 4x32-10 (key 0, counter 0: 6627e8d5 e169c58d bc57ac4c 9b00dbd8, and the two others). A change
// here changes every run of every seed.
TEST(RandomStream, GoldenValues) {
  const RandomStream gyro(42, "imu0/gyro");
  EXPECT_EQ(gyro.BitsAt(0), 0xa24285d4411ee17eULL);
  EXPECT_EQ(gyro.BitsAt(1), 0xb809c9520a4efa14ULL);
  EXPECT_EQ(gyro.BitsAt(std::uint64_t{1} << 40), 0x5961fa802e5f6cdeULL);
  EXPECT_EQ(RandomStream(0, "").BitsAt(0), 0x80fd0d7114b0efc9ULL);
}

TEST(RandomStream, RandomAccessEqualsSequence) {
  RandomStream sequence(7, "imu0/accel");
  const RandomStream access(7, "imu0/accel");
  for (std::uint64_t n = 0; n < 100; ++n) EXPECT_EQ(sequence.Bits(), access.BitsAt(n));
  EXPECT_EQ(sequence.Uniform(), access.UniformAt(100));
  EXPECT_EQ(sequence.Gaussian(), access.GaussianAt(101));
  EXPECT_EQ(sequence.Bits(), access.BitsAt(102));
}

TEST(RandomStream, CountsBeyond32Bits) {
  const RandomStream stream(7, "x");
  EXPECT_NE(stream.BitsAt(0), stream.BitsAt(std::uint64_t{1} << 32));
}

TEST(RandomStream, SeedAndNameBothMatter) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const char* name : {"imu0/gyro", "imu0/accel", "cam0", "cam1", "sonar0", ""}) {
      first.insert(RandomStream(seed, name).BitsAt(0));
    }
  }
  EXPECT_EQ(first.size(), 600U);
}

double Correlation(const RandomStream& a, const RandomStream& b, std::uint64_t shift) {
  constexpr std::uint64_t kCount = 20'000;
  double sum = 0.0;
  for (std::uint64_t n = 0; n < kCount; ++n) sum += a.GaussianAt(n) * b.GaussianAt(n + shift);
  return sum / kCount;
}

TEST(RandomStream, StreamsAreIndependent) {
  constexpr double kFourSigma = 4.0 / 141.4;  // 1/sqrt(20 000)
  const RandomStream cam0(1, "cam0");
  EXPECT_LT(std::abs(Correlation(cam0, RandomStream(1, "cam1"), 0)), kFourSigma);
  EXPECT_LT(std::abs(Correlation(cam0, RandomStream(2, "cam0"), 0)), kFourSigma);
  EXPECT_LT(std::abs(Correlation(cam0, cam0, 1)), kFourSigma);
  EXPECT_LT(std::abs(Correlation(cam0, RandomStream(2, "cam0"), 1)), kFourSigma);
}

TEST(RandomStream, UniformFillsItsInterval) {
  RandomStream stream(3, "uniform");
  std::array<int, 16> cells{};
  constexpr int kCount = 160'000;
  for (int i = 0; i < kCount; ++i) {
    const double u = stream.Uniform();
    ASSERT_GT(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++cells[static_cast<std::size_t>(u * 16.0)];
  }
  double chi_squared = 0.0;
  for (const int cell : cells) chi_squared += std::pow(cell - kCount / 16.0, 2) / (kCount / 16.0);
  EXPECT_LT(chi_squared, 37.7);  // 99.9 % at 15 degrees of freedom.
  const double between = stream.Uniform(-3.0, -2.0);
  EXPECT_GT(between, -3.0);
  EXPECT_LT(between, -2.0);
}

TEST(RandomStream, GaussianHasTheMomentsOfTheNormalDistribution) {
  RandomStream stream(4, "gaussian");
  constexpr int kCount = 1'000'000;
  std::array<double, 4> moments{};
  int beyond_three = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = stream.Gaussian();
    double power = 1.0;
    for (double& moment : moments) moment += (power *= x) / kCount;
    if (std::abs(x) > 3.0) ++beyond_three;
  }
  // Four standard deviations of the estimates: sqrt(1, 2, 15, 96) / 1000.
  EXPECT_NEAR(moments[0], 0.0, 0.004);
  EXPECT_NEAR(moments[1], 1.0, 0.0057);
  EXPECT_NEAR(moments[2], 0.0, 0.0155);
  EXPECT_NEAR(moments[3], 3.0, 0.0392);
  EXPECT_NEAR(beyond_three / 1e6, 0.0026998, 4 * 5.2e-5);
}

/// P(X < x) for a standard normal X, in long double; accurate in both tails.
long double NormalCdf(long double x) {
  return 0.5L * std::erfc(-x / std::numbers::sqrt2_v<long double>);
}

/// The inverse by Newton's method from a start nearby.
long double InverseByNewton(long double p, long double start) {
  long double x = start;
  for (int i = 0; i < 5; ++i) {
    const long double density = std::exp(-0.5L * x * x) * std::numbers::inv_sqrtpi_v<long double> /
                                std::numbers::sqrt2_v<long double>;
    x -= (NormalCdf(x) - p) / density;
  }
  return x;
}

TEST(InverseNormal, AgreesWithErfc) {
  for (const double p :
       {1e-300,   1e-200, 1e-100, 1e-30, 1e-16,  1e-12, 1.4e-11, 1.3e-11,  1e-9,
        1e-6,     1e-3,   0.01,   0.074, 0.0751, 0.1,   0.25,    0.4,      0.49999,
        0.500001, 0.6,    0.75,   0.925, 0.9251, 0.99,  0.999,   1 - 1e-6, 1 - 1e-9}) {
    const double x = InverseNormal(p);
    const long double exact = InverseByNewton(p, x);
    EXPECT_NEAR(static_cast<double>((x - exact) / exact), 0.0, 1e-15) << "p = " << p;
  }
}

TEST(InverseNormal, KnownQuantiles) {
  EXPECT_EQ(InverseNormal(0.5), 0.0);
  EXPECT_NEAR(InverseNormal(0.975), 1.959963984540054, 1e-15);
  EXPECT_NEAR(InverseNormal(0.0013498980316300933), -3.0, 1e-14);
  EXPECT_EQ(InverseNormal(0.25), -InverseNormal(0.75));
}

TEST(InverseNormal, IsMonotoneOverTheSeams) {
  for (const double seam : {0.075, 0.925, std::exp(-25.0)}) {
    double last = InverseNormal(seam * (1 - 1e-6));
    for (int i = 1; i <= 2000; ++i) {
      const double next = InverseNormal(seam * (1 - 1e-6 + i * 1e-9));
      EXPECT_GT(next, last);
      last = next;
    }
  }
}

}  // namespace
}  // namespace drydock
