// The transform that lays an estimate upon the truth before the two are compared.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scoring/association.h"
#include "sensors_models/base/pose.h"

namespace drydock::score {

enum class Alignment {
  kNone,    ///< As they are.
  kOrigin,  ///< The first poses laid upon each other: A = T_truth,0 * T_estimate,0^-1.
  kYaw,     ///< Least squares over all positions with rotation about z alone (gravity is known).
  kSe3,     ///< Least squares over all positions (Umeyama without scale).
  kSim3,    ///< The same with scale (Umeyama): for monocular estimates and the scale error.
};

/// "none", "origin", "yaw", "se3" or "sim3".
std::string_view ToString(Alignment alignment);
/// The inverse; InputError that lists what is allowed.
Alignment ParseAlignment(std::string_view name);

/// x -> scale * R * x + t.
struct Similarity {
  double scale = 1.0;
  Pose rigid;

  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const {
    return scale * (rigid.q() * x) + rigid.p();
  }
  /// A pose of the estimate in the truth's world; orientation is not scaled.
  Pose operator*(const Pose& pose) const { return {rigid.q() * pose.q(), *this * pose.p()}; }
};

/// What takes the estimate's world to the truth's. Nothing if the pairs do not determine it: fewer
/// than one (kOrigin), two (kYaw) or three (kSe3, kSim3), all on a vertical (kYaw), or with less
/// than two singular values of the cross-covariance above 2.2e-16 (kSe3, kSim3: all on a line).
std::optional<Similarity> Align(const std::vector<PosePair>& pairs, Alignment alignment);

/// Lays one pose of the estimate upon the truth by position and yaw alone: for drift from there on.
Similarity AlignPositionAndYaw(const PosePair& pair);

}  // namespace drydock::score
