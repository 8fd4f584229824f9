// What waits for an estimator that takes its time, as on a robot.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "estimator/interface/estimator.h"
#include "sensors_models/measurement/measurement.h"

namespace drydock {

struct RealtimeConfig {
  /// Stereo frames that may wait, at least 1: one too many drives out the oldest.
  int frame_queue = 1;
};

/// How an estimator kept up.
struct RealtimeReport {
  std::int64_t frames = 0;  ///< Stereo frames that arrived.
  std::vector<Time> drops;  ///< When frames that waited made room for newer ones, rising.
  Duration longest_wait;    ///< From an arrival until the estimator began with it.
};

/// Measurements between their arrival and an estimator that does one thing at a time. All are
/// handed on in the order of their arrival; only stereo frames are ever dropped.
class RealtimeQueue {
 public:
  /// One measurement's turn.
  struct Turn {
    Measurement measurement;
    Time begin;  ///< When the estimator begins with it: once it has arrived and the last is done.
  };

  explicit RealtimeQueue(const RealtimeConfig& config) : config_(config) {}

  /// The next measurement, if the estimator begins with it by `now`. Done() must follow.
  std::optional<Turn> Next(Time now);
  /// The estimator was done with the last turn at `t`.
  void Done(Time t) { idle_from_ = t; }
  /// `measurement` arrives, Next() having nothing more by that time.
  void Arrive(const Measurement& measurement);

  const RealtimeReport& report() const { return report_; }

 private:
  RealtimeConfig config_;
  std::deque<Measurement> waiting_;  // In the order of their arrival.
  int waiting_frames_ = 0;
  Time idle_from_;
  RealtimeReport report_;
};

/// What an event log should say of dropped frames: a line for those of a second.
std::vector<EstimatorEvent> DescribeDrops(const RealtimeReport& report);

}  // namespace drydock
