// The graph of keyframes that corrects odometry's drift by loops (paper, "Loop-closing and
// relocalization", eq. 17 and 18).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimator/svin2/pose_graph/loop_consistency.h"
#include "estimator/svin2/pose_graph/odometry_chain.h"
#include "estimator/svin2/pose_graph/pose_graph_types.h"

namespace drydock::svin2 {

/// What takes a pose in odometry's frame to the graph's; nothing, rather than the rounding of a
/// product, where they are the same bits.
std::optional<Pose> CorrectionBetween(const Pose& T_WI, const Pose& T_GI);

/// Keyframes, and edges that say where one is as seen from another. Grows by a node at a time;
/// memory is linear in nodes and edges. G is the graph's frame: where W would be had odometry not
/// drifted.
///
/// What no edge ties to each other are components: maps, until a believed loop edge merges them.
/// The oldest node of the graph stays where odometry has it. Odometry lays a new map where the one
/// before has brought it: so the oldest node of another component has the correction of the node
/// before it. A component without a believed loop edge keeps odometry's shape.
class PoseGraph {
 public:
  explicit PoseGraph(const LoopCheckConfig& loop_check = {});

  /// Until the next Optimise() and Apply() the node moves with the node before it.
  void AddNode(const PoseGraphNode& node);
  /// Both nodes must be there; a sequence edge leads to the newest one. Odometry's drift is
  /// reckoned along the first sequence edge between each node and the one before it.
  void AddEdge(const PoseGraphEdge& edge);

  /// Moves the nodes to where edges agree best: eq. 18 in 6 degrees of freedom, with the edges'
  /// covariances as weights and Huber's loss on loop edges. Leaves the graph as it is, so that it
  /// may run on a copy while this one grows. The same graph gives the same bits.
  PoseGraphResult Optimise(const PoseGraphOptions& options) const;
  /// Takes over a result of this graph or of an earlier copy of it. Nodes added since move by the
  /// correction of the last node that was optimised.
  void Apply(const PoseGraphResult& result);

  const std::vector<PoseGraphNode>& nodes() const { return nodes_; }
  /// Sequence and covisible edges, in the order of their coming.
  const std::vector<PoseGraphEdge>& links() const { return links_; }
  const std::vector<PoseGraphEdge>& loops() const { return loops_; }
  /// Of the last result that was applied; loops added since have none.
  const std::vector<LoopVerdict>& verdicts() const { return verdicts_; }
  /// Where the nodes are by what is known now, in their order.
  const std::vector<Pose>& T_GI() const { return T_GI_; }

  /// Position in nodes() of the node with this index; std::logic_error if there is none.
  std::size_t PositionOf(std::int64_t index) const;

  /// What takes odometry's frame to the graph's at a node, by its position.
  Pose CorrectionOf(std::size_t node) const;
  /// What takes odometry's frame to the graph's, for the newest node and all that follow it.
  Pose T_GW() const;

 private:
  void CarryAlong(std::size_t first);

  std::vector<PoseGraphNode> nodes_;
  std::vector<Pose> T_GI_;
  std::vector<PoseGraphEdge> links_, loops_;
  std::vector<LoopVerdict> verdicts_;
  OdometryChain chain_;
  LoopConsistency consistency_;
};

}  // namespace drydock::svin2
