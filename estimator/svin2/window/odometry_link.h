// What odometry says of two frames.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// A keyframe as the one before it has it.
struct OdometryLink {
  Pose T_before_now;
  /// Of n in measured = true.BoxPlus(n): [m, rad], left perturbation, in I at the keyframe before.
  Eigen::Matrix<double, 6, 6> covariance;
};

/// The way between two poses of the body, from the covariance of their errors: [p, alpha] of the
/// one before, then of the one now, left perturbations [m, rad], in W.
OdometryLink LinkBetween(const Pose& T_W_before, const Pose& T_W_now,
                         const Eigen::Matrix<double, 12, 12>& covariance);

}  // namespace drydock::svin2
