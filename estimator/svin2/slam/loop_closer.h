// From keyframes to loops, and to where the keyframes are with all loops closed (paper,
// "Loop-closing and Relocalization").
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/interface/stage_timings.h"
#include "estimator/svin2/slam/loop_closer_config.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "sensors_models/base/worker.h"

namespace drydock::svin2 {

/// Remembers all keyframes of a dive, some 50 kB each. Deterministic.
class LoopCloser {
 public:
  /// `worker` optimises the pose graph beside the rest, with the same results; null: in Add().
  LoopCloser(const LoopCloserConfig& config, const StereoSheet& sheet,
             std::shared_ptr<const Vocabulary> vocabulary, Worker* worker);

  /// The next keyframe or glimpse, by rising time. Looks whether its place is known.
  void Add(Keyframe keyframe);
  /// Closes all loops that are there.
  void Finish();

  const PoseGraph& graph() const { return graph_.graph(); }
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  /// Loops that hold, but for those that the pose graph does not believe.
  std::vector<LoopClosure> Loops() const;

  std::vector<EstimatorEvent> TakeEvents() { return std::exchange(events_, {}); }
  EstimatorTimings Timings() const { return clock_.Summary(); }

 private:
  struct Candidate {
    std::size_t then = 0;            // In keyframes_.
    std::optional<Pose> T_then_now;  // A guess, where there is one.
  };
  struct Loop {
    std::size_t then = 0;
    Relocalisation found;
  };

  /// How many keyframes, from the first on, may be candidates.
  std::size_t NumOldEnough(const Keyframe& now) const;
  std::vector<Candidate> FindCandidates(const Keyframe& now, const BagOfWords& bag);
  std::vector<Candidate> FindNearby(const Keyframe& now, std::size_t count) const;
  std::optional<Loop> Verify(const Keyframe& now, const BagOfWords& bag,
                             const std::vector<Candidate>& candidates);
  std::optional<OdometryLink> LinkOf(const Keyframe& now) const;
  std::vector<PoseGraphEdge> EdgesOf(const Keyframe& now, const std::optional<Loop>& loop) const;
  PoseGraphEdge EdgeOfGlimpse(const Keyframe& now, const Loop& loop) const;
  void Report(const Keyframe& now, const Loop& loop);
  std::size_t PlaceOf(KeyframeIndex index) const;

  LoopCloserConfig config_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  PlaceDatabase places_;
  CandidateConsistency consistency_;
  StereoGeometry rig_;
  LoopChecker checker_;
  DelayedPoseGraph graph_;

  std::vector<Keyframe> keyframes_;
  std::vector<LoopClosure> loops_;  // As many as the graph has, in its order.
  std::vector<EstimatorEvent> events_;
  StageClock clock_;
};

}  // namespace drydock::svin2
