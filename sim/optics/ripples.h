// The waves of a water surface that repeats from tile to tile.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sensors_models/base/time.h"
#include "sim/optics/caustics_config.h"

namespace drydock::sim {

/// Gravity waves on deep water, omega = sqrt(g k) (Airy; surface tension, which counts below 7 cm,
/// is left out). Their lengths spread evenly on a logarithmic scale about the middle one and all
/// are equally steep, as in the saturated range of a wind sea (Phillips 1958); directions are
/// random, as likely as the cosine of their angle from the wind's; phases are random. Wave vectors
/// are those nearest that fit a whole number of times into the tile along x and y.
class Ripples {
 public:
  static constexpr int kWaves = 32;

  /// One wave: height (steepness / k) cos(k . p - omega t + phase), so the slope's amplitude is
  /// `steepness` along k.
  struct Wave {
    int nx;             ///< Waves a tile along x,
    int ny;             ///< and y.
    double steepness;   ///< Height times k.
    double omega;       ///< [rad/s]
    double phase;       ///< At time 0 [rad].
    Eigen::Vector2d k;  ///< [rad/m]
  };

  Ripples(const CausticsConfig& config, std::uint64_t seed);

  const std::vector<Wave>& waves() const { return waves_; }

  /// Phase of a wave at the origin [rad, from 0 to 2 pi].
  static double PhaseAt(const Wave& wave, Time t);

  /// Gradient of the surface's height at `p_W` [m].
  Eigen::Vector2d SlopeAt(const Eigen::Vector2d& p_W, Time t) const;

 private:
  std::vector<Wave> waves_;
};

}  // namespace drydock::sim
