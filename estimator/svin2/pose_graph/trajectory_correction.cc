#include "estimator/svin2/pose_graph/trajectory_correction.h"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

/// From `a` to `b` along the straight line of SE(3), a screw: T(s) = a Exp(s Log(a^-1 b)).
Pose Between(const Pose& a, const Pose& b, double share) {
  const Pose step = a.Inverse() * b;
  const Eigen::Vector3d phi = LogSO3(step.q());
  const Eigen::Vector3d rho = LeftJacobianInverseSO3(phi) * step.p();
  return a * Pose(ExpSO3(share * phi), LeftJacobianSO3(share * phi) * (share * rho));
}

/// How much odometry has come to doubt up to each of its poses: what its standard deviations have
/// grown by; and, for want of them, time.
std::vector<double> Doubts(const Trajectory& odometry, std::span<const double> sigmas_m) {
  constexpr double kEachSecond = 1e-6;  // So that there is always some, if little beside the rest.
  std::vector<double> doubts(odometry.size(), 0.0);
  for (std::size_t k = 1; k < odometry.size(); ++k) {
    const double grown = sigmas_m.empty() ? 0.0 : std::max(0.0, sigmas_m[k] - sigmas_m[k - 1]);
    doubts[k] = doubts[k - 1] + grown + kEachSecond * (odometry[k].t - odometry[k - 1].t).Seconds();
  }
  return doubts;
}

}  // namespace

Trajectory Corrected(const PoseGraph& graph, const Trajectory& odometry,
                     std::span<const double> sigmas_m) {
  Check(sigmas_m.empty() || sigmas_m.size() == odometry.size(), "{} sigmas of {} poses",
        sigmas_m.size(), odometry.size());
  const auto& nodes = graph.nodes();
  Trajectory corrected = odometry;
  if (nodes.empty()) return corrected;
  const std::vector<double> doubts = Doubts(odometry, sigmas_m);
  const auto doubt_at = [&](const PoseGraphNode& node) {
    const auto at = std::ranges::lower_bound(odometry, node.t, {}, &StampedPose::t);
    return at == odometry.end() ? doubts.back()
                                : doubts[static_cast<std::size_t>(at - odometry.begin())];
  };
  std::size_t next = 0;  // The first keyframe that is not before the frame.
  for (std::size_t k = 0; k < corrected.size(); ++k) {
    StampedPose& frame = corrected[k];
    while (next < nodes.size() && nodes[next].t < frame.t) ++next;
    Pose T_GW;
    if (next == nodes.size()) {
      T_GW = graph.CorrectionOf(next - 1);
    } else if (next == 0 || nodes[next].t == frame.t) {
      T_GW = graph.CorrectionOf(next);
    } else {
      const double before = doubt_at(nodes[next - 1]);
      const double grown = doubt_at(nodes[next]) - before;  // 0 only where frames are missing.
      const double share = grown > 0.0 ? std::clamp((doubts[k] - before) / grown, 0.0, 1.0) : 1.0;
      T_GW = Between(graph.CorrectionOf(next - 1), graph.CorrectionOf(next), share);
    }
    frame.T_WI = T_GW * frame.T_WI;
  }
  return corrected;
}

}  // namespace drydock::svin2
