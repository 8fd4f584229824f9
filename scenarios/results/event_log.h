// What happened to an estimator on the way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/interface/estimator.h"

namespace drydock {

/// Notes each change of an estimator's status or map, and what the estimator says of itself, a line
/// each.
class EventLog {
 public:
  /// `estimate` is what the estimator said at `t`; times are noted from `start` on.
  explicit EventLog(Time start = {}) : start_(start) {}

  void Look(Time t, const std::optional<NavEstimate>& estimate);
  void Note(const EstimatorEvent& event);
  /// All lines in the order of their times.
  std::vector<std::string> Take();

 private:
  struct Entry {
    Time t;
    std::string what;
  };

  Time start_;
  bool looked_ = false;
  TrackingStatus status_ = TrackingStatus::kInitialising;
  int map_id_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace drydock
