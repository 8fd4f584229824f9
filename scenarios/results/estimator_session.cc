#include "scenarios/results/estimator_session.h"

#include "scenarios/results/stopwatch.h"

namespace drydock {

void EstimatorSession::Add(const Measurement& measurement) {
  {
    const Stopwatch watch(seconds_);
    estimator_->Add(measurement);
  }
  Look(measurement.t_arrival);
  Listen();
}

Results EstimatorSession::Finish() {
  {
    const Stopwatch watch(seconds_);
    estimator_->Finish();
  }
  Listen();
  return {estimator_->Odometry(),
          estimator_->Corrected(),
          estimator_->Loops(),
          estimator_->Map(),
          log_.Take(),
          estimator_->Timings(),
          std::move(beliefs_),
          starts_.FalseStarts()};
}

void EstimatorSession::Look(Time t) {
  const std::optional<NavEstimate> estimate = estimator_->Latest();
  log_.Look(t, estimate);
  starts_.Look(t, estimate);
  if (!estimate || !estimate->pose_covariance) return;
  const NavState& state = estimate->state;
  if (!beliefs_.empty() && state.t <= beliefs_.back().t) return;
  beliefs_.push_back({state.t, state.T_WI, *estimate->pose_covariance, estimate->map_id});
}

void EstimatorSession::Listen() {
  for (const EstimatorEvent& event : estimator_->TakeEvents()) log_.Note(event);
}

}  // namespace drydock
