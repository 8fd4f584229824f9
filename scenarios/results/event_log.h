// What happened to an estimator on the way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/interface/estimator.h"

namespace drydock {

/// Notes each change of an estimator's status or map, a line each.
class EventLog {
 public:
  /// `estimate` is what the estimator said at `t`; times are noted from `start` on.
  explicit EventLog(Time start = {}) : start_(start) {}

  void Look(Time t, const std::optional<NavEstimate>& estimate);
  std::vector<std::string> Take() { return std::move(events_); }

 private:
  Time start_;
  TrackingStatus status_ = TrackingStatus::kInitialising;
  int map_id_ = 0;
  std::vector<std::string> events_;
};

}  // namespace drydock
