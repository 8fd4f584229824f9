// An estimator at work, and what it says on the way.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "estimator/interface/estimator.h"
#include "scenarios/results/event_log.h"
#include "scenarios/results/result_files.h"
#include "scenarios/results/start_watch.h"

namespace drydock {

/// Hands measurements to an estimator that has been started, and keeps what it publishes: the same
/// for simulated and recorded ones.
class EstimatorSession {
 public:
  /// Events are noted with their time since `start`.
  explicit EstimatorSession(std::unique_ptr<Estimator> estimator, Time start = {})
      : estimator_(std::move(estimator)), log_(start) {}

  void Add(const Measurement& measurement);
  /// No more measurements will come.
  Results Finish();

  /// What the estimator has cost so far [s of wall-clock time].
  double seconds() const { return seconds_; }

 private:
  /// Looks at what the estimator says at `t`.
  void Look(Time t);
  void Listen();

  std::unique_ptr<Estimator> estimator_;
  EventLog log_;
  StartWatch starts_;
  std::vector<score::Belief> beliefs_;
  double seconds_ = 0.0;
};

}  // namespace drydock
