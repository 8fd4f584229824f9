#include "scenarios/results/event_log.h"

#include <algorithm>
#include <string_view>
#include <utility>

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
  if (looked_ && status == status_ && map_id == map_id_) return;
  entries_.push_back({t, fmt::format("{}, map {}", Describe(status), map_id)});
  looked_ = true;
  status_ = status;
  map_id_ = map_id;
}

void EventLog::Note(const EstimatorEvent& event) { entries_.push_back({event.t, event.message}); }

std::vector<std::string> EventLog::Take() {
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.t < b.t; });
  std::vector<std::string> lines;
  lines.reserve(entries_.size());
  for (const Entry& entry : std::exchange(entries_, {}))
    lines.push_back(fmt::format("{:.3f} s: {}", (entry.t - start_).Seconds(), entry.what));
  return lines;
}

}  // namespace drydock
