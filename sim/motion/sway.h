// The unsteadiness of a diver's hands.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "sim/motion/motion_config.h"

namespace drydock::sim {

/// A smooth random wobble of the six degrees of freedom [x y z (m), yaw pitch roll (rad)]: sums of
/// sines from 0.08 to 0.5 Hz with random frequencies and phases, fading in from rest over the first
/// seconds.
class Sway {
 public:
  using Vector = Eigen::Matrix<double, 6, 1>;
  struct Sample {
    Vector value;
    Vector rate;          ///< d/dt
    Vector acceleration;  ///< d2/dt2
  };

  Sway(const SwayConfig& config, std::uint64_t seed);

  /// At `t` [s]; everything is zero for t <= 0.
  Sample At(double t) const;

 private:
  static constexpr int kTones = 4;
  struct Tone {
    double amplitude = 0.0;
    double frequency = 0.0;  ///< [rad/s]
    double phase = 0.0;      ///< [rad]
  };
  std::array<std::array<Tone, kTones>, 6> tones_;
};

}  // namespace drydock::sim
