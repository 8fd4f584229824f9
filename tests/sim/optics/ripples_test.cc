#include "sim/optics/ripples.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

CausticsConfig Config() {
  CausticsConfig config;
  config.slope_rms = 0.1;
  return config;
}

TEST(Ripples, HaveTheSlopeAskedFor) {
  const Ripples ripples(Config(), 1);
  constexpr int kSide = 64;
  double sum = 0.0;
  for (int t = 0; t < 10; ++t) {
    for (int i = 0; i < kSide * kSide; ++i) {
      const Eigen::Vector2d place(i % kSide, i / kSide);
      sum += ripples.SlopeAt(4.0 / kSide * place, Time::FromSeconds(t)).squaredNorm();
    }
  }
  EXPECT_NEAR(std::sqrt(sum / (10 * kSide * kSide)), 0.1, 0.01);
}

// A wave length's crests pass in sqrt(2 pi length / g).
TEST(Ripples, RunAsGravityWavesDo) {
  const Ripples ripples(Config(), 1);
  for (const Ripples::Wave& wave : ripples.waves()) {
    const double length = 4.0 / std::hypot(wave.nx, wave.ny);
    const double period = std::sqrt(2.0 * std::numbers::pi * length / 9.81);
    const Time now = Time::FromSeconds(100.0);
    const double half = Ripples::PhaseAt(wave, now) -
                        Ripples::PhaseAt(wave, now + Duration::FromSeconds(period / 2.0));
    EXPECT_NEAR(std::abs(half), std::numbers::pi, 1e-6);
    // In the direction of k: what is here now is further along k later.
    const double step = 0.01 * period;
    const double later = wave.k.norm() * 0.01 * length +
                         Ripples::PhaseAt(wave, now + Duration::FromSeconds(step)) -
                         Ripples::PhaseAt(wave, now);
    EXPECT_NEAR(std::remainder(later, 2.0 * std::numbers::pi), 0.0, 1e-6);
  }
}

TEST(Ripples, LengthsAndDirectionsAreThoseOfTheWind) {
  CausticsConfig config = Config();
  config.wind_azimuth_deg = 90.0;
  double along = 0.0;
  const Ripples ripples(config, 3);
  for (const Ripples::Wave& wave : ripples.waves()) {
    const double length = 2.0 * std::numbers::pi / wave.k.norm();
    EXPECT_GT(length, 0.5 * 0.7 * 0.9);
    EXPECT_LT(length, 2.0 * 0.7 * 1.2);
    EXPECT_GE(wave.ny, 0);
    along += wave.k.normalized().y() / Ripples::kWaves;
  }
  EXPECT_NEAR(along, std::numbers::pi / 4.0, 0.15);  // The mean of cos^2 over that of cos.
}

TEST(Ripples, RepeatFromTileToTileAndHangOnTheSeed) {
  const Ripples ripples(Config(), 1), other(Config(), 2);
  const Time t = Time::FromSeconds(3.3);
  const Eigen::Vector2d place(0.7, -1.9);
  const Eigen::Vector2d slope = ripples.SlopeAt(place, t);
  EXPECT_NEAR((ripples.SlopeAt(place + Eigen::Vector2d(4.0, -8.0), t) - slope).norm(), 0.0, 1e-12);
  EXPECT_EQ(Ripples(Config(), 1).SlopeAt(place, t), slope);
  EXPECT_GT((other.SlopeAt(place, t) - slope).norm(), 1e-3);
}

CausticsConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "s.yaml"), [](YamlReader& yaml) { return ReadCaustics(yaml); });
}

TEST(CausticsConfig, IsReadStrictly) {
  EXPECT_EQ(Read("{}\n").slope_rms, 0.0);
  const CausticsConfig config =
      Read("{slope_rms: 0.05, wavelength_m: 1, wind_azimuth_deg: -30, tile_m: 8}\n");
  EXPECT_EQ(config.slope_rms, 0.05);
  EXPECT_EQ(config.wavelength_m, 1.0);
  EXPECT_EQ(config.wind_azimuth_deg, -30.0);
  EXPECT_EQ(config.tile_m, 8.0);
  EXPECT_THROW(Read("slope_rms: -0.1\n"), InputError);
  EXPECT_THROW(Read("slope_rms: 0.5\n"), InputError);
  EXPECT_THROW(Read("tile_m: 2\n"), InputError);
  EXPECT_THROW(Read("{wavelength_m: 0.1, tile_m: 4}\n"), InputError);
  EXPECT_THROW(Read("slope: 0.1\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
