#include "scenarios/results/estimator_session.h"

#include <limits>

namespace drydock {

void EstimatorSession::Add(const Measurement& measurement) {
  if (!queue_) {
    HandOver(measurement, measurement.t_arrival);
    return;
  }
  WorkUntil(measurement.t_arrival);
  queue_->Arrive(measurement);
}

Results EstimatorSession::Finish() {
  WorkUntil({std::numeric_limits<std::int64_t>::max()});
  {
    const Stopwatch watch(seconds_, clock_);
    estimator_->Finish();
  }
  Listen();
  if (queue_)
    for (const EstimatorEvent& event : DescribeDrops(queue_->report())) log_.Note(event);
  Results results{estimator_->Odometry(),
                  estimator_->Corrected(),
                  estimator_->Loops(),
                  estimator_->Map(),
                  log_.Take(),
                  estimator_->Timings(),
                  std::move(beliefs_),
                  starts_.FalseStarts(),
                  std::nullopt};
  if (queue_) results.realtime = queue_->report();
  return results;
}

void EstimatorSession::WorkUntil(Time now) {
  if (!queue_) return;
  while (const auto turn = queue_->Next(now))
    queue_->Done(HandOver(turn->measurement, turn->begin));
}

Time EstimatorSession::HandOver(const Measurement& measurement, Time begin) {
  double cost = 0.0;
  {
    const Stopwatch watch(cost, clock_);
    estimator_->Add(measurement);
  }
  seconds_ += cost;
  const Time end = queue_ ? begin + Duration::FromSeconds(cost) : begin;
  Look(end);
  Listen();
  return end;
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
