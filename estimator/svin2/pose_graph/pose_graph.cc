#include "estimator/svin2/pose_graph/pose_graph.h"

#include <algorithm>

#include "estimator/svin2/factors/relative_pose_factor.h"
#include "estimator/svin2/pose_graph/pose_graph_solver.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

std::optional<Pose> CorrectionBetween(const Pose& T_WI, const Pose& T_GI) {
  if (T_GI.p() == T_WI.p() && T_GI.q().coeffs() == T_WI.q().coeffs()) return std::nullopt;
  return T_GI * T_WI.Inverse();
}

PoseGraph::PoseGraph(const LoopCheckConfig& loop_check) : consistency_(loop_check) {
  Check(loop_check.max_chi2 > 0.0 && loop_check.sigma_factor > 0.0,
        "the bound and the factor of the check on loops must be above 0");
}

void PoseGraph::AddNode(const PoseGraphNode& node) {
  Check(nodes_.empty() || (node.index > nodes_.back().index && node.t > nodes_.back().t),
        "keyframe {} comes after a later one", node.index);
  nodes_.push_back(node);
  T_GI_.push_back(node.T_WI);
  chain_.AddNode();
  CarryAlong(nodes_.size() - 1);
}

void PoseGraph::AddEdge(const PoseGraphEdge& edge) {
  const std::size_t from = PositionOf(edge.from), to = PositionOf(edge.to);
  Check(from < to, "an edge leads from an older keyframe, not from {} to {}", edge.from, edge.to);
  WhiteningOf(edge.covariance);  // Throws here what the solver could not use.
  if (edge.kind == EdgeKind::kLoop) {
    loops_.push_back(edge);
    consistency_.Add(chain_, from, to, edge.T_from_to, edge.covariance);
    return;
  }
  links_.push_back(edge);
  if (edge.kind != EdgeKind::kSequence) return;
  Check(to + 1 == nodes_.size(), "a sequence edge leads to the newest keyframe, not to {}",
        edge.to);
  Check(loops_.empty() || loops_.back().to != edge.to, "a loop came before a sequence edge to {}",
        edge.to);
  if (from + 1 == to) chain_.Link(edge.T_from_to, edge.covariance);
}

std::size_t PoseGraph::PositionOf(std::int64_t index) const {
  const auto at = std::lower_bound(
      nodes_.begin(), nodes_.end(), index,
      [](const PoseGraphNode& node, std::int64_t value) { return node.index < value; });
  Check(at != nodes_.end() && at->index == index, "there is no keyframe {}", index);
  return static_cast<std::size_t>(at - nodes_.begin());
}

PoseGraphResult PoseGraph::Optimise(const PoseGraphOptions& options) const {
  std::vector<LoopVerdict> verdicts(loops_.size(), LoopVerdict::kBelieved);
  if (options.check_loops) verdicts = consistency_.Verdicts();
  return PoseGraphSolver(*this, options, std::move(verdicts)).Solve();
}

void PoseGraph::Apply(const PoseGraphResult& result) {
  Check(result.T_GI.size() <= nodes_.size() && result.verdicts.size() <= loops_.size(),
        "a result of {} keyframes for a graph of {}", result.T_GI.size(), nodes_.size());
  std::copy(result.T_GI.begin(), result.T_GI.end(), T_GI_.begin());
  verdicts_ = result.verdicts;
  CarryAlong(result.T_GI.size());
}

Pose PoseGraph::CorrectionOf(std::size_t node) const {
  return CorrectionBetween(nodes_[node].T_WI, T_GI_[node]).value_or(Pose::Identity());
}

void PoseGraph::CarryAlong(std::size_t first) {
  for (std::size_t k = first; k < nodes_.size(); ++k) {
    T_GI_[k] = k > 0 ? CorrectionOf(k - 1) * nodes_[k].T_WI : nodes_[k].T_WI;
  }
}

Pose PoseGraph::T_GW() const {
  return nodes_.empty() ? Pose::Identity() : CorrectionOf(nodes_.size() - 1);
}

}  // namespace drydock::svin2
