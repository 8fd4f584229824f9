#include "sim/optics/ripples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sensors_models/base/random_stream.h"

namespace drydock::sim {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

Ripples::Ripples(const CausticsConfig& config, std::uint64_t seed) {
  RandomStream random(seed, "water/ripples");
  const double wind = config.wind_azimuth_deg * std::numbers::pi / 180.0;
  // Each wave has half the square of its steepness for its mean square slope.
  const double steepness = config.slope_rms * std::sqrt(2.0 / kWaves);
  for (int i = 0; i < kWaves; ++i) {
    const double octave = 2.0 * (i + random.Uniform()) / kWaves - 1.0;
    const double waves_a_tile = config.tile_m / (config.wavelength_m * std::exp2(octave));
    const double direction = wind + std::asin(random.Uniform(-1.0, 1.0));
    Wave wave{};
    wave.nx = static_cast<int>(std::lround(waves_a_tile * std::cos(direction)));
    wave.ny = static_cast<int>(std::lround(waves_a_tile * std::sin(direction)));
    wave.k = kTurn / config.tile_m * Eigen::Vector2d(wave.nx, wave.ny);
    wave.steepness = steepness;
    wave.omega = std::sqrt(kGravity * wave.k.norm());
    wave.phase = kTurn * random.Uniform();
    waves_.push_back(wave);
  }
}

double Ripples::PhaseAt(const Wave& wave, Time t) {
  const double phase = std::fmod(wave.phase - wave.omega * t.Seconds(), kTurn);
  return phase < 0.0 ? phase + kTurn : phase;
}

Eigen::Vector2d Ripples::SlopeAt(const Eigen::Vector2d& p_W, Time t) const {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (const Wave& wave : waves_) {
    slope -= wave.steepness * std::sin(wave.k.dot(p_W) + PhaseAt(wave, t)) * wave.k.normalized();
  }
  return slope;
}

}  // namespace drydock::sim
