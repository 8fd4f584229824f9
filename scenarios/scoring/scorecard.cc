#include "scenarios/scoring/scorecard.h"

#include <algorithm>
#include <cmath>

#include "scenarios/scoring/initialisation.h"
#include "sensors_models/base/check.h"

namespace drydock::score {
namespace {

/// Of the poses from `from` on, under the alignment of the whole trajectory [m].
std::optional<double> AteFrom(const TrajectoryScore& score, Time from) {
  std::vector<PosePair> later;
  for (const PosePair& pair : score.association.pairs) {
    if (pair.t >= from) later.push_back(pair);
  }
  const auto statistics = Summarize(AbsoluteErrors(later, score.transform).translation);
  return statistics ? std::optional(statistics->rmse) : std::nullopt;
}

std::optional<double> TimeToNextPose(const Trajectory& trajectory, Time from) {
  const auto next = std::find_if(trajectory.begin(), trajectory.end(),
                                 [from](const StampedPose& pose) { return pose.t >= from; });
  if (next == trajectory.end()) return std::nullopt;
  return (next->t - from).Seconds();
}

/// What is set in `known` stands; what is not finite does not exist.
void Settle(const Metrics& known, Metrics& metrics) {
  for (const MetricInfo& info : AllMetrics()) {
    auto& value = metrics.*info.value;
    if (known.*info.value) value = known.*info.value;
    if (value && !std::isfinite(*value)) value.reset();
  }
}

void FillFromOdometry(const RunInfo& run, const Trajectory& truth, const Trajectory& odometry,
                      Metrics& metrics) {
  const auto score = TryScoreTrajectories(truth, odometry, Alignment::kSe3);
  metrics.ate_odometry_rmse_m = score ? score->metrics.ate_rmse_m : std::nullopt;
  if (metrics.ate_rmse_m && metrics.ate_odometry_rmse_m)
    metrics.ate_to_odometry = *metrics.ate_rmse_m / *metrics.ate_odometry_rmse_m;
  metrics.continuity_percent = 100.0 * Continuity(truth, odometry, kMaxGap);
  metrics.init_time_s = TimeToNextPose(odometry, truth.front().t);
  metrics.init_scale_error_percent = InitialScaleErrorPercent(truth, odometry);
  if (run.last_fault_end) metrics.recovery_time_s = TimeToNextPose(odometry, *run.last_fault_end);
}

}  // namespace

bool Scorecard::Passed() const {
  return std::all_of(criteria.begin(), criteria.end(),
                     [](const CriterionResult& result) { return result.passed; });
}

Scorecard Score(const RunInfo& run, const Trajectory& truth, const Trajectory& odometry,
                const Trajectory& final_trajectory, const std::vector<Criterion>& criteria) {
  RequireInput(!truth.empty(), "the true trajectory is empty");
  Scorecard card;
  card.run = run;
  card.path_length_m = PathLength(truth);
  card.duration_s = (truth.back().t - truth.front().t).Seconds();
  if (const auto score = TryScoreTrajectories(truth, final_trajectory, Alignment::kSe3)) {
    card.metrics = score->metrics;
    card.alignment = score->transform;
    if (run.last_fault_end) card.metrics.ate_after_fault_m = AteFrom(*score, *run.last_fault_end);
  }
  FillFromOdometry(run, truth, odometry, card.metrics);
  Settle(run.known, card.metrics);
  for (const Criterion& criterion : criteria) {
    card.criteria.push_back(Judge(criterion, card.metrics));
  }
  return card;
}

}  // namespace drydock::score
