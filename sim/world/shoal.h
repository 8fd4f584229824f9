// Fish that swim together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sim/world/closed_curve.h"
#include "sim/world/moving_body.h"
#include "sim/world/moving_things_config.h"

namespace drydock::sim {

/// Each fish follows a closed curve of its own at a constant pace, all of them a variation of one
/// that the seed chooses, and once round in the same time, so that the shoal stays together. A
/// fish heads along its path; behind its head the body bends with the path, and a wave runs through
/// it that grows towards the tail. It beats once on 0.7 of its length, and its tail swings by about
/// 0.2 of its length from side to side (Bainbridge 1958).
class Shoal {
 public:
  /// `name` tells this shoal from others, also to the random numbers.
  Shoal(const ShoalConfig& config, const std::vector<CreaturePart>& parts, std::uint64_t seed,
        const std::string& name);

  /// The parts of the first fish from the head on, then of the second...
  const std::vector<MovingBody>& bodies() const { return bodies_; }
  /// T_WB of these at `t` [s], a smooth function.
  std::vector<Pose> At(double t, const Pose& T_WI) const;

 private:
  struct Fish {
    ClosedCurve path;
    double start = 0.0;  ///< Along its path at t = 0 [m].
    double speed = 0.0;  ///< [m/s]
    double size = 0.0;   ///< [m]
    double beat = 0.0;   ///< [rad/s]
    double phase = 0.0;  ///< [rad]
  };
  void AddPoses(const Fish& fish, double t, std::vector<Pose>& poses) const;

  std::vector<double> joints_;  ///< Of a fish one metre long [m].
  std::vector<Fish> fish_;
  std::vector<MovingBody> bodies_;
};

}  // namespace drydock::sim
