#include "estimator/svin2/pose_graph/delayed_pose_graph.h"

#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

/// On the heap, where the worker finds it whatever becomes of its owner's address.
struct DelayedPoseGraph::Run {
  explicit Run(PoseGraph graph) : snapshot(std::move(graph)) {}

  PoseGraph snapshot;
  PoseGraphResult result;
  std::future<void> done;  // Only with a worker.
};

DelayedPoseGraph::DelayedPoseGraph(const DelayedPoseGraphConfig& config, Worker* worker)
    : config_(config), worker_(worker), graph_(config.loop_check) {
  Check(config.delay_keyframes >= 0, "a delay of {} keyframes", config.delay_keyframes);
}

DelayedPoseGraph::~DelayedPoseGraph() {
  if (run_ && run_->done.valid()) run_->done.wait();
}

void DelayedPoseGraph::AddEdge(const PoseGraphEdge& edge) {
  graph_.AddEdge(edge);
  if (edge.kind == EdgeKind::kLoop) wanted_ = true;
}

bool DelayedPoseGraph::AddKeyframe(const PoseGraphNode& node,
                                   std::span<const PoseGraphEdge> edges) {
  graph_.AddNode(node);
  for (const PoseGraphEdge& edge : edges) AddEdge(edge);
  bool taken = false;
  // Twice where there is no delay: what begins now is taken now.
  while (true) {
    if (run_ && graph_.nodes().size() >= run_->snapshot.nodes().size() +
                                             static_cast<std::size_t>(config_.delay_keyframes)) {
      Take();
      taken = true;
    }
    if (run_ || !wanted_) return taken;
    Begin();
  }
}

void DelayedPoseGraph::Begin() {
  wanted_ = false;
  run_ = std::make_unique<Run>(graph_);
  const auto optimise = [run = run_.get(), options = config_.options] {
    run->result = run->snapshot.Optimise(options);
  };
  if (worker_ == nullptr) {
    optimise();
  } else {
    run_->done = worker_->Submit(optimise);
  }
}

void DelayedPoseGraph::Take() {
  const std::unique_ptr<Run> run = std::move(run_);
  if (run->done.valid()) run->done.get();
  graph_.Apply(run->result);
  report_ = run->result.report;
}

void DelayedPoseGraph::Finish() {
  if (run_) Take();
  Begin();
  Take();
}

}  // namespace drydock::svin2
