// What a loop says, in the conventions of those who use it.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// The drift of odometry: maps its W into the frame of the pose graph. `T_graph_then` is then's
/// pose in the graph, `T_W_now` now's by odometry.
Pose Drift(const Pose& T_graph_then, const Pose& T_then_now, const Pose& T_W_now);

/// A relocalisation's covariance is that of [dp, da] in T_then_now = (p + dp, exp(da) q), in then's
/// body frame. Here it is for T_now_then = T_then_now^-1, in now's body frame.
Eigen::Matrix<double, 6, 6> CovarianceOfInverse(const Pose& T_then_now,
                                                const Eigen::Matrix<double, 6, 6>& covariance);

/// For a tangent on the right, [dp, da] in now's body frame: T_then_now * (dp, exp(da)).
Eigen::Matrix<double, 6, 6> CovarianceOnTheRight(const Pose& T_then_now,
                                                 const Eigen::Matrix<double, 6, 6>& covariance);

/// For a tangent of SE(3) on the left, Exp([rho, phi]) * T_then_now, in then's body frame, where
/// the rotation swings the position about then's origin.
Eigen::Matrix<double, 6, 6> CovarianceOnSe3(const Pose& T_then_now,
                                            const Eigen::Matrix<double, 6, 6>& covariance);

}  // namespace drydock::svin2
