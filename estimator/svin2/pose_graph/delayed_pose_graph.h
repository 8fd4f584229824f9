// The pose graph beside the odometry, with results that do not hang on timing.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <span>

#include "estimator/svin2/pose_graph/pose_graph.h"
#include "sensors_models/base/worker.h"

namespace drydock::svin2 {

struct DelayedPoseGraphConfig {
  LoopCheckConfig loop_check;
  PoseGraphOptions options;
  /// An optimisation's result is taken when so many more keyframes or glimpses have come, however
  /// long it took: if it is not ready then, it is waited for. 0: at once.
  int delay_frames = 2;
};

/// A pose graph that optimises a copy of itself whenever a loop has come, one at a time.
class DelayedPoseGraph {
 public:
  /// `worker` optimises; null: it happens within the calls, with the same results.
  DelayedPoseGraph(const DelayedPoseGraphConfig& config, Worker* worker);
  ~DelayedPoseGraph();
  DelayedPoseGraph(const DelayedPoseGraph&) = delete;
  DelayedPoseGraph& operator=(const DelayedPoseGraph&) = delete;

  /// A keyframe and the edges that lead to it. Then takes the result that is due, if any, and
  /// begins to optimise if loops have come since it last began. True: a result was applied.
  bool AddKeyframe(const PoseGraphNode& node, std::span<const PoseGraphEdge> edges);
  /// The same of a frame that is no keyframe, and an edge between keyframes that it has found.
  bool AddGlimpse(const std::optional<PoseGraphEdge>& edge);
  /// Optimises with all that is there and applies the result, at once.
  void Finish();

  const PoseGraph& graph() const { return graph_; }
  /// Of the last result that was applied.
  const std::optional<PoseGraphReport>& report() const { return report_; }

 private:
  struct Run;

  void AddEdge(const PoseGraphEdge& edge);
  bool Proceed();
  void Begin();
  void Take();

  DelayedPoseGraphConfig config_;
  Worker* worker_;
  PoseGraph graph_;
  std::unique_ptr<Run> run_;  // Under way, or waiting to be taken.
  int frames_since_ = 0;      // It began.
  bool wanted_ = false;
  std::optional<PoseGraphReport> report_;
};

}  // namespace drydock::svin2
