#include "sim/motion/sway.h"

#include <cmath>
#include <numbers>

#include "sensors_models/base/random_stream.h"

namespace drydock::sim {
namespace {

/// A number with its first two derivatives by time.
struct Jet {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2.0 * a.rate * b.rate + a.value * b.acceleration};
}

/// Rises from 0 to 1 in `kFadeIn` seconds with four continuous derivatives:
/// 126 s^5 - 420 s^6 + 540 s^7 - 315 s^8 + 70 s^9, whose slope is 630 s^4 (1 - s)^4.
Jet FadeIn(double t) {
  constexpr double kFadeIn = 4.0;
  const double s = t / kFadeIn;
  if (s <= 0.0) return {};
  if (s >= 1.0) return {1.0, 0.0, 0.0};
  const double s4 = s * s * s * s;
  const double c = 1.0 - s;
  const double value = s4 * s * (126.0 + s * (-420.0 + s * (540.0 + s * (-315.0 + s * 70.0))));
  const double slope = 630.0 * s4 * c * c * c * c;
  const double bend = 2520.0 * s * s * s * c * c * c * (c - s);
  return {value, slope / kFadeIn, bend / (kFadeIn * kFadeIn)};
}

}  // namespace

Sway::Sway(const SwayConfig& config, std::uint64_t seed) {
  constexpr std::array<double, kTones> kShares = {0.8, 0.5, 0.3, 0.15};
  constexpr std::array<double, kTones> kFrequencies = {0.09, 0.17, 0.29, 0.44};  // [Hz]
  RandomStream stream(seed, "motion/sway");
  for (std::size_t axis = 0; axis < tones_.size(); ++axis) {
    const double scale = axis < 3 ? config.position_m : config.angle_rad;
    for (int k = 0; k < kTones; ++k) {
      Tone& tone = tones_[axis][k];
      // A sine's rms is 0.71 of its amplitude; the shares' squares add up to 1.
      tone.amplitude = std::numbers::sqrt2 * scale * kShares[k];
      tone.frequency = 2.0 * std::numbers::pi * kFrequencies[k] * stream.Uniform(0.85, 1.15);
      tone.phase = stream.Uniform(0.0, 2.0 * std::numbers::pi);
    }
  }
}

Sway::Sample Sway::At(double t) const {
  const Jet fade = FadeIn(t);
  Sample sample;
  for (std::size_t axis = 0; axis < tones_.size(); ++axis) {
    Jet sum;
    for (const Tone& tone : tones_[axis]) {
      const double angle = tone.frequency * t + tone.phase;
      const double sine = tone.amplitude * std::sin(angle);
      sum.value += sine;
      sum.rate += tone.amplitude * tone.frequency * std::cos(angle);
      sum.acceleration -= tone.frequency * tone.frequency * sine;
    }
    const Jet swayed = fade * sum;
    const auto row = static_cast<Eigen::Index>(axis);
    sample.value[row] = swayed.value;
    sample.rate[row] = swayed.rate;
    sample.acceleration[row] = swayed.acceleration;
  }
  return sample;
}

}  // namespace drydock::sim
