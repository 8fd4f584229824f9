// One optimisation of the pose graph, by Ceres.
#pragma once

#include <vector>

#include "estimator/svin2/pose_graph/pose_graph.h"

namespace drydock::svin2 {

/// Joins elements 0 to n - 1 to sets, each known by its smallest element.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size);

  std::size_t SmallestOf(std::size_t element);
  void Join(std::size_t a, std::size_t b);

 private:
  std::vector<std::size_t> parents_;
};

class PoseGraphSolver {
 public:
  /// Refers to `graph`. One verdict for each loop.
  PoseGraphSolver(const PoseGraph& graph, const PoseGraphOptions& options,
                  std::vector<LoopVerdict> verdicts);

  PoseGraphResult Solve();

 private:
  struct End {
    std::size_t from = 0, to = 0;
  };

  End EndsOf(const PoseGraphEdge& edge) const;
  void JoinComponents();
  /// Moves each rigid part as a whole to where the first loop that ties it to its component has it.
  void PlaceParts();
  void MovePart(std::size_t part, const Pose& motion);
  /// False: there is no solution, and nothing is moved.
  bool Minimise();
  /// Moves components as the node before their oldest has been moved.
  void FollowOn();

  const PoseGraph& graph_;
  PoseGraphOptions options_;
  PoseGraphResult result_;
  DisjointSets parts_;          // By links.
  DisjointSets components_;     // By links and believed loops.
  std::vector<bool> has_loop_;  // By a component's oldest node.
};

}  // namespace drydock::svin2
