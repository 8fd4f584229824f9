// Whether the cameras can be relied on.
#pragma once

#include <optional>

#include "estimator/interface/estimator.h"

namespace drydock::svin2 {

/// Vision has failed where a frame sees too few landmarks. The estimator then carries on by inertia
/// and depth, for as long as that can be trusted; afterwards it is lost, until it starts afresh.
class TrackingMonitor {
 public:
  struct Config {
    double longest_blindness_s = 15.0;  ///< Longer than that, and dead reckoning is not believed.
  };

  explicit TrackingMonitor(const Config& config) : config_(config) {}

  /// The next frame, and whether it sees landmarks enough.
  TrackingStatus Update(Time t, bool sees_enough);
  TrackingStatus Status() const { return status_; }
  /// A new map begins.
  void Restart() { *this = TrackingMonitor(config_); }

 private:
  Config config_;
  TrackingStatus status_ = TrackingStatus::kInitialising;
  std::optional<Time> last_seen_;
};

}  // namespace drydock::svin2
