// Starts of an estimator that were given up again.
#pragma once

#include <optional>

#include "estimator/interface/estimator.h"

namespace drydock {

/// Counts false starts: the estimator had left initialisation, and within 5 s was initialising
/// again or in another map. What is lost later is a matter of continuity.
class StartWatch {
 public:
  /// `estimate` is what the estimator said at `t`.
  void Look(Time t, const std::optional<NavEstimate>& estimate);
  /// Nothing if it never left initialisation.
  std::optional<int> FalseStarts() const;

 private:
  bool ever_started_ = false;
  std::optional<Time> started_;
  int map_id_ = 0;
  int false_starts_ = 0;
};

}  // namespace drydock
