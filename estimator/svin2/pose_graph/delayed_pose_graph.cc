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
  Check(config.delay_frames >= 0, "a delay of {} frames", config.delay_frames);
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
  return Proceed();
}

bool DelayedPoseGraph::AddGlimpse(const std::optional<PoseGraphEdge>& edge) {
  if (edge.has_value()) AddEdge(*edge);
  return Proceed();
}

/// A frame is through. Takes what is due and begins what is wanted; true if a result was applied.
bool DelayedPoseGraph::Proceed() {
  bool taken = false;
  ++frames_since_;
  // Twice where there is no delay: what begins now is taken now.
  while (true) {
    if (run_ && frames_since_ >= config_.delay_frames) {
      Take();
      taken = true;
    }
    if (run_ || !wanted_) return taken;
    Begin();
  }
}

void DelayedPoseGraph::Begin() {
  wanted_ = false;
  frames_since_ = 0;
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
