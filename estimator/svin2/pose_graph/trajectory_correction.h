// Odometry's whole trajectory, laid on the corrected keyframes.
#pragma once

#include <span>

#include "estimator/svin2/pose_graph/pose_graph.h"
#include "sensors_models/base/trajectory.h"

namespace drydock::svin2 {

/// `odometry` [in W] moved to the graph's frame. Between two keyframes the correction goes from
/// that of the one to that of the other along the straight line of SE(3) (a screw); before the
/// first and after the last it stays. At a keyframe it is the keyframe's own, so that what odometry
/// thought better of since keeps its distance from it.
///
/// `sigmas_m`, one a pose of the odometry, are the standard deviations that it gives its positions:
/// the correction grows as they do, for drift grows where sight fails. Without them, by time.
Trajectory Corrected(const PoseGraph& graph, const Trajectory& odometry,
                     std::span<const double> sigmas_m = {});

}  // namespace drydock::svin2
