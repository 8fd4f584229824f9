// The diver's own arm, which reaches into the view.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sim/world/moving_body.h"
#include "sim/world/moving_things_config.h"

namespace drydock::sim {

/// Goes along with I and sways a little. It is stretched out within kReachTime after it is wanted
/// (from the start of the dive it is there at once) and drawn back as fast before it is no more.
class DiverArm {
 public:
  /// `parts` is one: MakeArm() of the scenes says where its elbow and finger tips are.
  DiverArm(const MovingThingConfig& times, const DiverArmConfig& config,
           const std::vector<CreaturePart>& parts, std::uint64_t seed, const std::string& name);

  const std::vector<MovingBody>& bodies() const { return bodies_; }
  /// T_WB at `t` [s] with the body at `T_WI`.
  std::vector<Pose> At(double t, const Pose& T_WI) const;

  static constexpr double kReachTime = 1.2;  ///< [s]

 private:
  struct Tone {
    double amplitude = 0.0;
    double frequency = 0.0;  ///< [rad/s]
    double phase = 0.0;      ///< [rad]
  };
  /// How far it is stretched out, from 0 to 1.
  double Stretched(double t) const;

  double from_;
  double to_;
  Pose T_IB_;  ///< Stretched out, without sway.
  /// Of the finger tips along x, y, z [m] and about the elbow [rad].
  std::array<std::array<Tone, 3>, 6> sway_;
  std::vector<MovingBody> bodies_;
};

}  // namespace drydock::sim
