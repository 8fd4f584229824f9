// All that moves through a dive beside the diver.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "sensors_models/base/time.h"
#include "sim/world/diver_arm.h"
#include "sim/world/moving_body.h"
#include "sim/world/moving_things_config.h"
#include "sim/world/shoal.h"

namespace drydock::sim {

/// Where each moving body is at any instant: a function of the seed, the time and the diver's pose
/// alone.
class MovingThings {
 public:
  /// Nothing moves.
  MovingThings() = default;
  /// std::logic_error if `creatures` lacks one that is asked for.
  MovingThings(const std::vector<MovingThingConfig>& things, const Creatures& creatures,
               std::uint64_t seed);

  const std::vector<MovingBody>& bodies() const { return bodies_; }
  /// T_WB of these at `t`, while the diver is at `T_WI`.
  MovingPoses At(Time t, const Pose& T_WI) const;

 private:
  struct Thing {
    double from = 0.0;  ///< [s]
    double to = 0.0;    ///< [s]
    std::variant<Shoal, DiverArm> what;
  };
  std::vector<Thing> things_;
  std::vector<MovingBody> bodies_;
};

}  // namespace drydock::sim
