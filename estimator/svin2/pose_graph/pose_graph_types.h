// What goes into the pose graph and what comes out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::svin2 {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// What is known of a pose by gravity and pressure, not by integration: it does not drift.
struct LevelSigmas {
  double z = 0.0;     ///< Height in W [m], > 0.
  double tilt = 0.0;  ///< Roll and pitch [rad], > 0.
};

/// A keyframe.
struct PoseGraphNode {
  std::int64_t index = 0;  ///< Rises from node to node.
  Time t;                  ///< Rises from node to node.
  Pose T_WI;               ///< As odometry has it.
  int map_id = 0;
  std::optional<LevelSigmas> level;
};

enum class EdgeKind {
  kSequence,   ///< By odometry.
  kCovisible,  ///< By much that both keyframes see; trusted as odometry is.
  kLoop,       ///< By recognising a place; believed only once it is consistent.
};

/// One keyframe as another, older one sees it.
struct PoseGraphEdge {
  std::int64_t from = 0;  ///< Index of a node,
  std::int64_t to = 0;    ///< and of a later one.
  Pose T_from_to;         ///< Maps points of I at `to` into I at `from`.
  /// Of n in measured = true.BoxPlus(n): [p (m), alpha (rad)], left perturbation, in I at `from`.
  Matrix6d covariance = Matrix6d::Identity();
  EdgeKind kind = EdgeKind::kSequence;
};

/// When a loop edge is believed (see LoopConsistency).
struct LoopCheckConfig {
  /// Of the six components by which two ways between two keyframes differ: 1 of 10 000 true ones
  /// is further off.
  double max_chi2 = 27.9;
  /// All standard deviations count this many times as large as edges say: odometry's errors are
  /// correlated and matches are not Gaussian.
  double sigma_factor = 2.0;
  /// Loops whose ends are within so many keyframes of each other see the same place.
  std::int64_t streak_keyframes = 10;
};

struct PoseGraphOptions {
  int iterations = 100;  ///< At most; it stops where the cost does.
  /// Huber's width on loop edges, in standard deviations of the residual's norm.
  double huber_sigmas = 3.5;
  /// Every edge weighs the same, as in the paper: an ablation.
  bool identity_weights = false;
  double huber_identity = 0.1;  ///< Huber's width then [m and rad].
  /// False: every loop edge is believed. An ablation.
  bool check_loops = true;
};

enum class LoopVerdict {
  kBelieved,
  kAgainstOdometry,  ///< Further off than odometry can have drifted.
  kAgainstLoops,     ///< At odds with other loops that weigh more.
};

struct PoseGraphReport {
  int iterations = 0;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  bool converged = true;  ///< Else it ran out of iterations.
  bool usable = true;     ///< Else the poses are those from before.
  int components = 0;     ///< Parts that nothing ties to each other.
};

/// Of the nodes and loops that the graph had when the optimisation began, in their order.
struct PoseGraphResult {
  PoseGraphReport report;
  std::vector<Pose> T_GI;
  std::vector<LoopVerdict> verdicts;
};

}  // namespace drydock::svin2
