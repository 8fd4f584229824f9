#include "scenarios/scoring/trajectory_score.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sensors_models/base/check.h"

namespace drydock::score {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double RootMeanSquare(const std::vector<double>& values) {
  const auto statistics = Summarize(values);
  return statistics ? statistics->rmse : 0.0;
}

/// The polygon of the truth's own poses between two instants, ends in between included [m].
double TruePathLength(const Trajectory& truth, Time from, Time to) {
  double length = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const StampedPose& a = truth[i - 1];
    const StampedPose& b = truth[i];
    const Duration inside = std::min(b.t, to) - std::max(a.t, from);
    if (inside.ns <= 0) continue;
    const double share = inside.Seconds() / (b.t - a.t).Seconds();
    length += share * (b.T_WI.p() - a.T_WI.p()).norm();
  }
  return length;
}

std::optional<double> FinalDriftPercent(const Trajectory& truth,
                                        const std::vector<PosePair>& pairs) {
  const double path = TruePathLength(truth, pairs.front().t, pairs.back().t);
  if (!(path > 0.0)) return std::nullopt;
  const Similarity start = AlignPositionAndYaw(pairs.front());
  const double miss = (start * pairs.back().estimate.p() - pairs.back().truth.p()).norm();
  return 100.0 * miss / path;
}

void FillYawAligned(const std::vector<PosePair>& pairs, Metrics& metrics) {
  const auto alignment = Align(pairs, Alignment::kYaw);
  if (!alignment) return;
  std::vector<double> yaw;
  std::vector<double> z;
  for (const PosePair& pair : pairs) {
    const Pose aligned = *alignment * pair.estimate;
    yaw.push_back(YawBetween(pair.truth.q(), aligned.q()) * kDegrees);
    z.push_back(aligned.p().z() - pair.truth.p().z());
  }
  metrics.yaw_error_deg = RootMeanSquare(yaw);
  metrics.z_rmse_m = RootMeanSquare(z);
}

void FillSteps(const std::vector<PosePair>& pairs, TrajectoryScore& score) {
  const StepOptions options;
  const PoseErrors errors = RelativeErrors(pairs, options);
  score.rpe_translation = Summarize(errors.translation);
  score.rpe_rotation = Summarize(errors.rotation);
  if (!score.rpe_translation) return;
  score.metrics.rpe_5m_percent = 100.0 * score.rpe_translation->mean / options.step;
  score.metrics.rpe_5m_deg_per_m = score.rpe_rotation->mean * kDegrees / options.step;
}

TrajectoryScore ScorePairs(const Trajectory& truth, const Trajectory& estimate,
                           Association association, Alignment alignment,
                           const Similarity& transform) {
  TrajectoryScore score;
  score.alignment = alignment;
  score.transform = transform;
  score.association = std::move(association);
  score.path_length_m = PathLength(truth);
  score.duration_s = (truth.back().t - truth.front().t).Seconds();
  const std::vector<PosePair>& pairs = score.association.pairs;
  const PoseErrors errors = AbsoluteErrors(pairs, transform);
  score.ape_translation = *Summarize(errors.translation);
  score.ape_rotation = *Summarize(errors.rotation);
  Metrics& metrics = score.metrics;
  metrics.ate_rmse_m = score.ape_translation.rmse;
  if (score.path_length_m > 0.0) {
    metrics.ate_percent = 100.0 * score.ape_translation.rmse / score.path_length_m;
  }
  metrics.scale_error_percent = ScaleErrorPercent(pairs);
  FillSteps(pairs, score);
  metrics.final_drift_percent = FinalDriftPercent(truth, pairs);
  FillYawAligned(pairs, metrics);
  metrics.continuity_percent = 100.0 * Continuity(truth, estimate, kMaxGap);
  metrics.init_time_s = (std::max(estimate.front().t, truth.front().t) - truth.front().t).Seconds();
  return score;
}

void RequireOverlap(const Trajectory& truth, const Trajectory& estimate,
                    const Association& association, const AssociationOptions& options) {
  RequireInput(!truth.empty(), "the true trajectory is empty");
  RequireInput(!estimate.empty(), "the estimated trajectory is empty");
  RequireInput(!association.pairs.empty(),
               "no pose of the estimate (times {:.6f} to {:.6f} s) has one of the truth ({:.6f} to "
               "{:.6f} s) {}: are both clocks the same?",
               estimate.front().t.Seconds(), estimate.back().t.Seconds(), truth.front().t.Seconds(),
               truth.back().t.Seconds(),
               options.mode == AssociationMode::kInterpolate
                   ? std::string("around it")
                   : fmt::format("within {} s", options.max_difference_s));
}

}  // namespace

TrajectoryScore ScoreTrajectories(const Trajectory& truth, const Trajectory& estimate,
                                  Alignment alignment, const AssociationOptions& options) {
  Association association = Associate(truth, estimate, options);
  RequireOverlap(truth, estimate, association, options);
  const auto transform = Align(association.pairs, alignment);
  RequireInput(transform.has_value(),
               "the {} associated poses do not determine an alignment '{}': too few, or all on a "
               "line",
               association.pairs.size(), ToString(alignment));
  TrajectoryScore score =
      ScorePairs(truth, estimate, std::move(association), alignment, *transform);
  score.association_options = options;
  return score;
}

std::optional<TrajectoryScore> TryScoreTrajectories(const Trajectory& truth,
                                                    const Trajectory& estimate, Alignment alignment,
                                                    const AssociationOptions& options) {
  try {
    return ScoreTrajectories(truth, estimate, alignment, options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<double> ScaleErrorPercent(const std::vector<PosePair>& pairs) {
  const auto similarity = Align(pairs, Alignment::kSim3);
  if (!similarity || !(similarity->scale > 0.0)) return std::nullopt;
  return 100.0 * (1.0 / similarity->scale - 1.0);
}

double Continuity(const Trajectory& truth, const Trajectory& estimate, Duration max_gap) {
  if (truth.empty()) return 0.0;
  const Time end = truth.back().t;
  std::optional<Time> first;
  Time last;
  Duration valid;
  for (const StampedPose& pose : estimate) {
    if (pose.t < truth.front().t || pose.t > end) continue;
    if (!first) {
      first = pose.t;
    } else if (pose.t - last <= max_gap) {
      valid = valid + (pose.t - last);
    }
    last = pose.t;
  }
  if (!first) return 0.0;
  if (end - last <= max_gap) valid = valid + (end - last);
  const Duration possible = end - *first;
  return possible.ns == 0 ? 1.0 : valid.Seconds() / possible.Seconds();
}

}  // namespace drydock::score
