// An estimator at work, and what it says on the way.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "estimator/interface/estimator.h"
#include "scenarios/results/event_log.h"
#include "scenarios/results/realtime_queue.h"
#include "scenarios/results/result_files.h"
#include "scenarios/results/start_watch.h"
#include "scenarios/results/stopwatch.h"

namespace drydock {

/// Hands measurements to an estimator that has been started, and keeps what it publishes: the same
/// for simulated and recorded ones.
///
/// In lock step the estimator has each measurement when it arrives, and takes no time. In real time
/// what it costs by the wall clock passes in the dive too, and measurements wait meanwhile.
class EstimatorSession {
 public:
  /// Events are noted with their time since `start`. Without `realtime`: lock step.
  explicit EstimatorSession(std::unique_ptr<Estimator> estimator, Time start = {},
                            const std::optional<RealtimeConfig>& realtime = std::nullopt,
                            WallClock clock = SteadySeconds)
      : estimator_(std::move(estimator)), log_(start), clock_(std::move(clock)) {
    if (realtime) queue_.emplace(*realtime);
  }

  /// `measurement` arrives; not before those that arrived earlier.
  void Add(const Measurement& measurement);
  /// No more measurements will come.
  Results Finish();

  /// What the estimator has cost so far [s of wall-clock time].
  double seconds() const { return seconds_; }

 private:
  /// Hands over what the estimator begins with by `now`.
  void WorkUntil(Time now);
  /// Begins with `measurement` at `begin`; gives when the estimator is done.
  Time HandOver(const Measurement& measurement, Time begin);
  /// Looks at what the estimator says at `t`.
  void Look(Time t);
  void Listen();

  std::unique_ptr<Estimator> estimator_;
  EventLog log_;
  StartWatch starts_;
  std::vector<score::Belief> beliefs_;
  WallClock clock_;
  std::optional<RealtimeQueue> queue_;  // In real time.
  double seconds_ = 0.0;
};

}  // namespace drydock
