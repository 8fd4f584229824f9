#include "estimator/svin2/pose_graph/trajectory_correction.h"

#include <Eigen/LU>

namespace drydock::svin2 {
namespace {

/// From `a` to `b` along the straight line of SE(3), a screw: T(s) = a Exp(s Log(a^-1 b)).
Pose Between(const Pose& a, const Pose& b, double share) {
  const Pose step = a.Inverse() * b;
  const Eigen::Vector3d phi = LogSO3(step.q());
  const Eigen::Vector3d rho = LeftJacobianInverseSO3(phi) * step.p();
  return a * Pose(ExpSO3(share * phi), LeftJacobianSO3(share * phi) * (share * rho));
}

}  // namespace

Trajectory Corrected(const PoseGraph& graph, const Trajectory& odometry) {
  const auto& nodes = graph.nodes();
  Trajectory corrected = odometry;
  if (nodes.empty()) return corrected;
  std::size_t next = 0;  // The first keyframe that is not before the frame.
  for (StampedPose& frame : corrected) {
    while (next < nodes.size() && nodes[next].t < frame.t) ++next;
    Pose T_GW;
    if (next == nodes.size()) {
      T_GW = graph.CorrectionOf(next - 1);
    } else if (next == 0 || nodes[next].t == frame.t) {
      T_GW = graph.CorrectionOf(next);
    } else {
      const Time before = nodes[next - 1].t;
      const double share = (frame.t - before).Seconds() / (nodes[next].t - before).Seconds();
      T_GW = Between(graph.CorrectionOf(next - 1), graph.CorrectionOf(next), share);
    }
    frame.T_WI = T_GW * frame.T_WI;
  }
  return corrected;
}

}  // namespace drydock::svin2
