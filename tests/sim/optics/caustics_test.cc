#include "sim/optics/caustics.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

constexpr int kSide = 256;
constexpr double kTile = 4.0;  // [m]
/// Of tiles that are computed, not interpolated.
double DepthOfTile(int tile) { return 0.16 * tile * tile; }

CausticsConfig Waves(double slope_rms) {
  CausticsConfig config;
  config.slope_rms = slope_rms;
  return config;
}

/// The surface is at z = 0.
WaterConfig Water(double visibility_m, double sun_elevation_deg) {
  WaterConfig water;
  water.visibility_m = visibility_m;
  water.sun_elevation_deg = sun_elevation_deg;
  water.surface_z_m = 0.0;
  return water;
}

/// The factors of a whole tile's places at one depth, row by row along x.
std::vector<float> Level(Caustics& caustics, double depth) {
  std::vector<float> x, y;
  for (int i = 0; i < kSide * kSide; ++i) {
    x.push_back(static_cast<float>(kTile / kSide * (i % kSide)));
    const int row = i / kSide;
    y.push_back(static_cast<float>(kTile / kSide * row));
  }
  const std::vector<float> z(x.size(), static_cast<float>(-depth));
  std::vector<float> factors(x.size(), 1.F);
  caustics.Modulate(kSide * kSide, x.data(), y.data(), z.data(), factors.data());
  return factors;
}

double Mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Standard deviation, which is the contrast where the mean is 1.
double Contrast(const std::vector<float>& values) {
  const double mean = Mean(values);
  double sum = 0.0;
  for (const float value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

float FactorAt(Caustics& caustics, float x, float y, float z) {
  float factor = 1.F;
  caustics.Modulate(1, &x, &y, &z, &factor);
  return factor;
}

TEST(Caustics, NoLightIsLostOrWon) {
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  for (const double seconds : {0.0, 7.3}) {
    caustics.SetTime(Time::FromSeconds(seconds));
    for (const double depth : {0.0, 0.1, 1.0, 2.56, 3.3, 7.0, 20.0, 60.0}) {
      const std::vector<float> level = Level(caustics, depth);
      EXPECT_NEAR(Mean(level), 1.0, 2e-5) << depth << " m";
      EXPECT_GE(*std::min_element(level.begin(), level.end()), 0.F);
    }
  }
}

TEST(Caustics, ContrastGrowsToAFocusAndFallsBelowIt) {
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  std::vector<double> contrast;
  for (const double depth : {0.0, 0.3, 1.0, 2.5, 5.0, 8.0, 15.0, 41.0})
    contrast.push_back(Contrast(Level(caustics, depth)));
  EXPECT_EQ(contrast[0], 0.0);
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_GT(contrast[i], 1.5 * contrast[i - 1]);
  for (std::size_t i = 4; i < contrast.size(); ++i) EXPECT_LT(contrast[i], 0.7 * contrast[i - 1]);
  EXPECT_GT(contrast[3], 0.6);
  EXPECT_LT(contrast.back(), 0.003);
}

// To first order in depth the factor is 1 minus the divergence of the light's displacement: below
// a crest it is brighter. Tells apart each sign, the sun's slant and the waves of the time.
TEST(Caustics, FocusesBelowCrests) {
  const CausticsConfig waves = Waves(0.1);
  const WaterConfig water = Water(0.0, 62.0);
  Caustics caustics(waves, water, 5);
  const Ripples ripples(waves, 5);
  const Time t = Time::FromSeconds(12.4);
  caustics.SetTime(t);
  const double depth = DepthOfTile(1);
  const Eigen::Vector3d sun = DirectionToSun(water);
  const Eigen::Matrix2d by_slope = ShiftBySlope(sun);
  double both = 0.0, seen = 0.0, expected = 0.0;
  for (int i = 0; i < 400; ++i) {
    const int row = i / 20;
    const Eigen::Vector2d below(0.21 * (i % 20), 0.19 * row);
    const Eigen::Vector2d above = below + depth * sun.head<2>() / sun.z();
    double divergence = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = 0.01 * Eigen::Vector2d::Unit(axis);
      divergence +=
          (by_slope * (ripples.SlopeAt(above + step, t) - ripples.SlopeAt(above - step, t)))[axis] /
          0.02;
    }
    const double factor = FactorAt(caustics, static_cast<float>(below.x()),
                                   static_cast<float>(below.y()), static_cast<float>(-depth)) -
                          1.0;
    both -= factor * depth * divergence;
    seen += factor * factor;
    expected += depth * divergence * depth * divergence;
  }
  EXPECT_GT(both / std::sqrt(seen * expected), 0.98);
  EXPECT_NEAR(both / expected, 1.0, 0.05);
}

/// Where light of direction `air` (down) goes under a surface of slope (x, y): how far aside a
/// metre of depth, by Snell's law.
Eigen::Vector2d Refract(const Eigen::Vector3d& air, const Eigen::Vector2d& slope) {
  constexpr double kIndex = 1.333;
  const Eigen::Vector3d normal = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  const Eigen::Vector3d across = (air - air.dot(normal) * normal) / kIndex;
  const Eigen::Vector3d water = across - std::sqrt(1.0 - across.squaredNorm()) * normal;
  return water.head<2>() / -water.z();
}

TEST(Caustics, TiltedFacetsShiftLightBySnellsLaw) {
  for (const double elevation : {90.0, 75.0, 62.0, 50.0}) {
    const Eigen::Vector3d sun = DirectionToSun(Water(12.0, elevation));
    Eigen::Vector3d air(-1.333 * sun.x(), -1.333 * sun.y(), 0.0);
    air.z() = -std::sqrt(1.0 - air.squaredNorm());
    ASSERT_NEAR((Refract(air, {0, 0}) + sun.head<2>() / sun.z()).norm(), 0.0, 1e-12);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d tilt = 1e-4 * Eigen::Vector2d::Unit(axis);
      const Eigen::Vector2d shift = (Refract(air, tilt) - Refract(air, -tilt)) / 2e-4;
      EXPECT_NEAR((ShiftBySlope(sun).col(axis) - shift).norm(), 0.0, 1e-6) << elevation;
    }
  }
  EXPECT_NEAR(ShiftBySlope({0, 0, 1})(0, 0), 1.0 - 1.0 / 1.333, 1e-12);
}

/// Standard deviation below waves so weak that light never crosses, as Fourier's components give
/// it: that of wave i is depth (1 - 1/n) k a, times what a disc of radius `sun_radius` leaves of
/// it.
double ExpectedContrast(const Ripples& ripples, double depth, double sun_radius) {
  double variance = 0.0;
  for (const Ripples::Wave& wave : ripples.waves()) {
    const double k = wave.k.norm();
    const double amplitude = depth * (1.0 - 1.0 / 1.333) * k * wave.steepness;
    const double argument = k * sun_radius * depth;
    const double left = argument > 0.0 ? 2.0 * std::cyl_bessel_j(1.0, argument) / argument : 1.0;
    variance += 0.5 * amplitude * amplitude * left * left;
  }
  return std::sqrt(variance);
}

// In perfectly clear water, under a sun in the zenith, nothing but its disc blurs.
TEST(Caustics, TheSunsDiscBlursTheMoreTheDeeper) {
  const CausticsConfig waves = Waves(0.002);
  Caustics caustics(waves, Water(0.0, 90.0), 1);
  const Ripples ripples(waves, 1);
  const double radius = std::tan(0.27 / 1.333 * std::numbers::pi / 180.0);
  for (const int tile : {3, 6, 10, 13}) {
    const double depth = DepthOfTile(tile);
    const double expected = ExpectedContrast(ripples, depth, radius);
    EXPECT_NEAR(Contrast(Level(caustics, depth)), expected, 0.05 * expected) << depth << " m";
  }
  // It counts, for the deepest:
  const double depth = DepthOfTile(13);
  EXPECT_LT(ExpectedContrast(ripples, depth, radius), 0.9 * ExpectedContrast(ripples, depth, 0.0));
}

// All scattering bends light too far: the pattern has what is not scattered.
TEST(Caustics, ScatteredLightHasNoPattern) {
  WaterConfig water = Water(6.0, 62.0);
  water.forward_scatter = 0.0;
  Caustics hazy(Waves(0.1), water, 1), clear(Waves(0.1), Water(0.0, 62.0), 1);
  const double b = (ScatteringAlbedo(water) * BeamAttenuation(water))[1];
  const double slant = std::sin(62.0 * std::numbers::pi / 180.0);
  for (const int tile : {3, 5}) {
    const double depth = DepthOfTile(tile);
    EXPECT_NEAR(Contrast(Level(hazy, depth)) / Contrast(Level(clear, depth)),
                std::exp(-b * depth / slant), 1e-3);
  }
  // Small bends blur: fine lines go first.
  WaterConfig soft = Water(6.0, 62.0);
  soft.forward_scatter = 1.0;
  Caustics blurred(Waves(0.1), soft, 1);
  EXPECT_LT(Contrast(Level(blurred, 2.56)), 0.8 * Contrast(Level(clear, 2.56)));
}

TEST(Caustics, RepeatFromTileToTile) {
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  for (int i = 0; i < 50; ++i) {
    const auto x = 0.083F * static_cast<float>(i), y = 0.031F * static_cast<float>(i);
    const float factor = FactorAt(caustics, x, y, -2.F);
    EXPECT_NEAR(FactorAt(caustics, x + 4.F, y, -2.F), factor, 0.01);
    EXPECT_NEAR(FactorAt(caustics, x - 16.F, y + 12.F, -2.F), factor, 0.01);
  }
}

TEST(Caustics, HangOnTimeAndSeedAlone) {
  const auto is_same = [](const std::vector<float>& a, const std::vector<float>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
  };
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  caustics.SetTime(Time::FromSeconds(1.0));
  const std::vector<float> first = Level(caustics, 3.0);
  caustics.SetTime(Time::FromSeconds(1.05));
  EXPECT_FALSE(is_same(Level(caustics, 3.0), first));
  caustics.SetTime(Time::FromSeconds(1.0));
  EXPECT_TRUE(is_same(Level(caustics, 3.0), first));
  // Nor on what was asked for before.
  Caustics again(Waves(0.1), Water(12.0, 62.0), 1), other(Waves(0.1), Water(12.0, 62.0), 2);
  again.SetTime(Time::FromSeconds(1.0));
  other.SetTime(Time::FromSeconds(1.0));
  Level(again, 9.0);
  EXPECT_TRUE(is_same(Level(again, 3.0), first));
  EXPECT_FALSE(is_same(Level(other, 3.0), first));
}

TEST(Caustics, ASmoothSurfaceHasNone) {
  Caustics caustics(Waves(0.0), Water(12.0, 62.0), 1);
  for (const float factor : Level(caustics, 3.3)) EXPECT_NEAR(factor, 1.F, 1e-3);
}

TEST(Caustics, ASunLowerThanUnderWaterCanBeIsAtTheHorizon) {
  const Eigen::Matrix2d lowest = ShiftBySlope(DirectionToSun(Water(12.0, 41.39)));
  EXPECT_NEAR((ShiftBySlope(DirectionToSun(Water(12.0, 10.0))) - lowest).norm(), 0.0, 0.02);
  Caustics caustics(Waves(0.1), Water(12.0, 10.0), 1);
  EXPECT_NEAR(Mean(Level(caustics, 2.0)), 1.0, 2e-5);
}

TEST(Caustics, PlacesThatAreNoneDoNoHarm) {
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(FactorAt(caustics, 1.F, 2.F, 5.F), 1.F);  // Above the water.
  for (const float bad : {kInfinity, -kInfinity, kNone, 1e30F}) {
    EXPECT_TRUE(std::isfinite(FactorAt(caustics, bad, 0.F, -1.F)));
    EXPECT_TRUE(std::isfinite(FactorAt(caustics, 0.F, bad, -1.F)));
    EXPECT_TRUE(std::isfinite(FactorAt(caustics, 0.F, 0.F, bad)));
  }
}

// Straight down from z = -1 on ground at -3, and on a step that is 1 m nearer.
TEST(Caustics, RowsOfPixelsAskAtWhatTheySee) {
  Caustics caustics(Waves(0.1), Water(12.0, 62.0), 1);
  constexpr int kWidth = 101;
  std::vector<float> columns, depth, sun(kWidth, 0.5F);
  for (int u = 0; u < kWidth; ++u) {
    columns.push_back(static_cast<float>(u - 50) / 600.F);
    depth.push_back(u < 61 ? 2.F : 1.F);
  }
  depth[20] = std::numeric_limits<float>::infinity();
  rows::RowView view{};
  view.columns = columns.data();
  view.width = kWidth;
  view.y = 0.3F;
  // x right is W's x, y down is W's -y, z forward is down.
  const float R_WC[3][3] = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::memcpy(view.R_WC, R_WC, sizeof R_WC);
  view.p_WC[2] = -1.F;
  caustics.ModulateRow(view, depth.data(), sun.data());
  for (int u = 0; u < kWidth; ++u) {
    const auto i = static_cast<std::size_t>(u);
    ASSERT_TRUE(std::isfinite(sun[i]));
    if (u == 20) continue;
    const float expected =
        0.5F * FactorAt(caustics, depth[i] * columns[i], -0.3F * depth[i], -1.F - depth[i]);
    // Odd pixels lie between two that ask, or at a step take the nearer one's.
    EXPECT_NEAR(sun[i], expected, u % 2 == 0 ? 1e-4F : 0.15F * expected) << u;
  }
}

}  // namespace
}  // namespace drydock::sim
