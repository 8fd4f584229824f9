#include "scenarios/results/event_log.h"

#include <string_view>

#include <fmt/format.h>

namespace drydock {
namespace {

std::string_view Describe(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::kInitialising:
      return "initialising";
    case TrackingStatus::kTracking:
      return "tracking";
    case TrackingStatus::kDeadReckoning:
      return "dead reckoning";
    case TrackingStatus::kLost:
      return "lost";
  }
  return "unknown";
}

}  // namespace

void EventLog::Look(Time t, const std::optional<NavEstimate>& estimate) {
  const TrackingStatus status = estimate ? estimate->status : TrackingStatus::kInitialising;
  const int map_id = estimate ? estimate->map_id : 0;
  if (!events_.empty() && status == status_ && map_id == map_id_) return;
  events_.push_back(
      fmt::format("{:.3f} s: {}, map {}", (t - start_).Seconds(), Describe(status), map_id));
  status_ = status;
  map_id_ = map_id;
}

}  // namespace drydock
