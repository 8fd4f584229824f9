#include "estimator/svin2/slam/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "estimator/svin2/loop/keyframe_landmarks.h"
#include "estimator/svin2/loop/loop_edge.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

/// Gravity and pressure know tilt and height without integrating: they do not drift.
std::optional<LevelSigmas> LevelOf(const Keyframe& keyframe) {
  if (!keyframe.covariance) return std::nullopt;
  const auto variances = keyframe.covariance->diagonal();
  return LevelSigmas{std::sqrt(variances[2]), std::sqrt(std::max(variances[3], variances[4]))};
}

PoseGraphNode NodeOf(const Keyframe& keyframe) {
  return {keyframe.index, keyframe.t, keyframe.T_WI, keyframe.map_id, LevelOf(keyframe)};
}

std::vector<Descriptor> DescriptorsOf(const Keyframe& keyframe) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(keyframe.points.size());
  for (const KeyframePoint& point : keyframe.points) descriptors.push_back(point.descriptor);
  return descriptors;
}

/// By how much odometry may have drifted from one keyframe to another [m]. Both covariances grow
/// from the start of their map.
double DriftSigma(const Keyframe& then, const Keyframe& now) {
  if (then.map_id != now.map_id || !then.covariance || !now.covariance)
    return std::numeric_limits<double>::infinity();
  const auto variance = [](const Keyframe& keyframe) {
    return keyframe.covariance->diagonal().head<3>().sum();
  };
  return std::sqrt(std::max(variance(now) - variance(then), 0.0));
}

/// How many points of one keyframe the other has too. Points are sorted by id.
int NumShared(const Keyframe& then, const Keyframe& now) {
  int shared = 0;
  auto at = now.points.begin();
  for (const KeyframePoint& point : then.points) {
    at = std::lower_bound(at, now.points.end(), point.id,
                          [](const KeyframePoint& p, LandmarkId id) { return p.id < id; });
    if (at == now.points.end()) break;
    if (at->id == point.id) ++shared;
  }
  return shared;
}

}  // namespace

LoopCloser::LoopCloser(const LoopCloserConfig& config, const StereoSheet& sheet,
                       std::shared_ptr<const Vocabulary> vocabulary, Worker* worker)
    : config_(config),
      vocabulary_(std::move(vocabulary)),
      places_(vocabulary_->words()),
      consistency_(config.consistency),
      rig_(sheet),
      checker_(config.check, rig_),
      graph_(config.graph, worker) {}

void LoopCloser::Add(Keyframe keyframe) {
  if (keyframe.is_glimpse && !(keyframe.link && LinkOf(keyframe))) return;
  TriangulateByStereo(rig_, keyframe);
  BagOfWords bag = vocabulary_->Transform(DescriptorsOf(keyframe), config_.index_level);
  const std::vector<Candidate> candidates = FindCandidates(keyframe, bag);
  const std::optional<Loop> loop = Verify(keyframe, bag, candidates);
  if (loop) Report(keyframe, *loop);
  if (keyframe.is_glimpse) {
    const StageClock::Lap lap(clock_, "pose graph");
    graph_.AddGlimpse(loop ? std::optional(EdgeOfGlimpse(keyframe, *loop)) : std::nullopt);
    return;
  }
  {
    const StageClock::Lap lap(clock_, "pose graph");
    graph_.AddKeyframe(NodeOf(keyframe), EdgesOf(keyframe, loop));
  }
  places_.Add(keyframe.index, std::move(bag));
  keyframes_.push_back(std::move(keyframe));
}

std::vector<LoopCloser::Candidate> LoopCloser::FindCandidates(const Keyframe& now,
                                                              const BagOfWords& bag) {
  const StageClock::Lap lap(clock_, "place recognition");
  const std::size_t old_enough = NumOldEnough(now);
  if (old_enough == 0) return {};
  std::vector<Candidate> candidates = FindNearby(now, old_enough);
  if (config_.max_verified == 0) return candidates;
  const std::vector<PlaceMatch> alike = consistency_.Update(
      places_.LoopCandidates(bag.words, {keyframes_.back().index},
                             keyframes_[old_enough - 1].index + 1, config_.candidates));
  int count = 0;
  std::size_t pairs = 0;
  for (const PlaceMatch& match : alike) {
    const std::size_t then = PlaceOf(match.keyframe);
    if (NumShared(keyframes_[then], now) > config_.max_tracked) continue;
    pairs += now.points.size() * keyframes_[then].points.size();
    if (++count > config_.max_verified && pairs > static_cast<std::size_t>(config_.max_pairs))
      break;
    candidates.push_back({then, std::nullopt});
  }
  return candidates;
}

std::size_t LoopCloser::NumOldEnough(const Keyframe& now) const {
  const Time latest = now.t - Duration::FromSeconds(config_.min_age_s);
  // What a glimpse finds is carried to the last keyframe, which is no loop to itself.
  const auto last = keyframes_.end() - (now.is_glimpse ? 1 : 0);
  const auto end = std::ranges::upper_bound(keyframes_.begin(), last, latest, {}, &Keyframe::t);
  return static_cast<std::size_t>(end - keyframes_.begin());
}

std::vector<LoopCloser::Candidate> LoopCloser::FindNearby(const Keyframe& now,
                                                          std::size_t count) const {
  const NearbyRule& rule = config_.nearby;
  const Pose T_GI = graph().T_GW() * now.T_WI;
  // By distance and angle, as shares of what is allowed.
  std::vector<std::pair<double, Candidate>> near;
  for (std::size_t k = 0; k < count; ++k) {
    const Keyframe& then = keyframes_[k];
    const Pose T_then_now = graph().T_GI()[k].Inverse() * T_GI;
    const double apart = std::max(T_then_now.p().norm() / rule.max_distance_m,
                                  LogSO3(T_then_now.q()).norm() / rule.max_angle_rad);
    if (apart >= 1.0 || DriftSigma(then, now) > rule.max_drift_sigma_m ||
        NumShared(then, now) > config_.max_tracked)
      continue;
    near.emplace_back(apart, Candidate{k, T_then_now});
  }
  std::ranges::stable_sort(near, {}, [](const auto& entry) { return entry.first; });
  std::vector<Candidate> candidates;
  for (const auto& [apart, candidate] : near) {
    if (std::ssize(candidates) == rule.max_candidates) break;
    candidates.push_back(candidate);
  }
  return candidates;
}

std::optional<LoopCloser::Loop> LoopCloser::Verify(const Keyframe& now, const BagOfWords& bag,
                                                   const std::vector<Candidate>& candidates) {
  const StageClock::Lap lap(clock_, "loop verification");
  for (const auto& [then, T_then_now] : candidates) {
    const Keyframe& old = keyframes_[then];
    const Keyframe around = LocalMapAround(rig_, config_.local_map, keyframes_, then);
    Relocalisation found =
        checker_.Check(now, bag.index, old, places_.DirectIndexOf(old.index), around, T_then_now);
    if (found.IsGood()) return Loop{then, std::move(found)};
  }
  return std::nullopt;
}

/// How odometry ties it to the keyframe before; a new map begins without. Where the window has
/// forgotten that one, both are as unsure as if they had nothing in common.
std::optional<OdometryLink> LoopCloser::LinkOf(const Keyframe& now) const {
  if (keyframes_.empty() || keyframes_.back().map_id != now.map_id) return std::nullopt;
  if (now.link) {
    const double factor = config_.step_sigma_factor * config_.step_sigma_factor;
    return OdometryLink{now.link->T_before_now, factor * now.link->covariance};
  }
  const Keyframe& before = keyframes_.back();
  if (!before.covariance || !now.covariance) return std::nullopt;
  Eigen::Matrix<double, 12, 12> both = Eigen::Matrix<double, 12, 12>::Zero();
  both.topLeftCorner<6, 6>() = *before.covariance;
  both.bottomRightCorner<6, 6>() = *now.covariance;
  return LinkBetween(before.T_WI, now.T_WI, both);
}

std::vector<PoseGraphEdge> LoopCloser::EdgesOf(const Keyframe& now,
                                               const std::optional<Loop>& loop) const {
  std::vector<PoseGraphEdge> edges;
  if (const auto link = LinkOf(now)) {
    edges.push_back({keyframes_.back().index, now.index, link->T_before_now, link->covariance,
                     EdgeKind::kSequence});
  }
  if (loop) {
    edges.push_back({keyframes_[loop->then].index, now.index, loop->found.T_then_now,
                     loop->found.covariance, EdgeKind::kLoop});
  }
  return edges;
}

PoseGraphEdge LoopCloser::EdgeOfGlimpse(const Keyframe& now, const Loop& loop) const {
  const auto [T_then_before, covariance] =
      AtKeyframeBefore({loop.found.T_then_now, loop.found.covariance}, *now.link);
  return {keyframes_[loop.then].index, keyframes_.back().index, T_then_before, covariance,
          EdgeKind::kLoop};
}

void LoopCloser::Report(const Keyframe& now, const Loop& loop) {
  const Keyframe& then = keyframes_[loop.then];
  loops_.push_back({now.t, then.t, loop.found.T_then_now});
  const Pose drift = Drift(then.T_WI, loop.found.T_then_now, now.T_WI);
  events_.push_back(
      {now.t, fmt::format("recognised the place of {:.2f} s before: {} points agree; odometry has "
                          "drifted by {:.3f} m since",
                          (now.t - then.t).Seconds(), loop.found.inliers.size(),
                          (drift * now.T_WI.p() - now.T_WI.p()).norm())});
}

void LoopCloser::Finish() {
  graph_.Finish();
  const std::size_t refused = loops_.size() - Loops().size();
  if (refused == 0) return;
  events_.push_back({keyframes_.back().t,
                     fmt::format("{} of {} places that were recognised contradict odometry or each "
                                 "other: no loops were closed there",
                                 refused, loops_.size())});
}

std::vector<LoopClosure> LoopCloser::Loops() const {
  std::vector<LoopClosure> believed;
  const std::vector<LoopVerdict>& verdicts = graph().verdicts();
  for (std::size_t i = 0; i < loops_.size(); ++i)
    if (i >= verdicts.size() || verdicts[i] == LoopVerdict::kBelieved)
      believed.push_back(loops_[i]);
  return believed;
}

std::size_t LoopCloser::PlaceOf(KeyframeIndex index) const {
  const auto at = std::ranges::lower_bound(keyframes_, index, {}, [](const Keyframe& keyframe) {
    return static_cast<KeyframeIndex>(keyframe.index);
  });
  Check(at != keyframes_.end() && at->index == index, "there is no such keyframe");
  return static_cast<std::size_t>(at - keyframes_.begin());
}

}  // namespace drydock::svin2
