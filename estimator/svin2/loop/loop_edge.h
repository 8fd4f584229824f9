// What a loop says, in the conventions of those who use it.
#pragma once

#include <Eigen/Core>

#include "estimator/svin2/window/odometry_link.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// The drift of odometry: maps its W into the frame of the pose graph. `T_graph_then` is then's
/// pose in the graph, `T_W_now` now's by odometry.
Pose Drift(const Pose& T_graph_then, const Pose& T_then_now, const Pose& T_W_now);

/// A relocalisation's covariance is that of [dp, da] in T_then_now = (p + dp, exp(da) q), in then's
/// body frame. Here it is for T_now_then = T_then_now^-1, in now's body frame.
Eigen::Matrix<double, 6, 6> CovarianceOfInverse(const Pose& T_then_now,
                                                const Eigen::Matrix<double, 6, 6>& covariance);

struct LoopEdge {
  Pose T_then_now;
  Eigen::Matrix<double, 6, 6> covariance;  ///< As a relocalisation has it.
};

/// A loop of a frame between keyframes as the keyframe before it would have it: T_then_before. The
/// errors of the two are taken to have nothing to do with each other.
LoopEdge AtKeyframeBefore(const LoopEdge& loop, const OdometryLink& link);

}  // namespace drydock::svin2
