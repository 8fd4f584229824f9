#include "scenarios/results/estimator_session.h"

#include "scenarios/results/stopwatch.h"

namespace drydock {

void EstimatorSession::Add(const Measurement& measurement) {
  {
    const Stopwatch watch(seconds_);
    estimator_->Add(measurement);
  }
  log_.Look(measurement.t_arrival, estimator_->Latest());
  Listen();
}

Results EstimatorSession::Finish() {
  {
    const Stopwatch watch(seconds_);
    estimator_->Finish();
  }
  Listen();
  return {estimator_->Odometry(), estimator_->Corrected(), estimator_->Loops(), log_.Take(),
          estimator_->Timings()};
}

void EstimatorSession::Listen() {
  for (const EstimatorEvent& event : estimator_->TakeEvents()) log_.Note(event);
}

}  // namespace drydock
