#include "estimator/svin2/odometry/tracking_monitor.h"

namespace drydock::svin2 {

TrackingStatus TrackingMonitor::Update(Time t, bool sees_enough) {
  if (status_ == TrackingStatus::kLost) return status_;
  if (!last_seen_ || sees_enough) last_seen_ = t;
  if (sees_enough) {
    status_ = TrackingStatus::kTracking;
  } else if ((t - *last_seen_).Seconds() > config_.longest_blindness_s) {
    status_ = TrackingStatus::kLost;
  } else {
    status_ = TrackingStatus::kDeadReckoning;
  }
  return status_;
}

}  // namespace drydock::svin2
