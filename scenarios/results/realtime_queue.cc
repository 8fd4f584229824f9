#include "scenarios/results/realtime_queue.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace drydock {
namespace {

constexpr Duration kSecond{kNanosecondsPerSecond};

bool IsFrame(const Measurement& measurement) {
  return std::holds_alternative<StereoFrame>(measurement.reading);
}

}  // namespace

std::optional<RealtimeQueue::Turn> RealtimeQueue::Next(Time now) {
  if (waiting_.empty()) return std::nullopt;
  const Time arrival = waiting_.front().t_arrival;
  const Time begin = std::max(arrival, idle_from_);
  if (begin > now) return std::nullopt;
  report_.longest_wait = std::max(report_.longest_wait, begin - arrival);
  Turn turn{std::move(waiting_.front()), begin};
  waiting_.pop_front();
  if (IsFrame(turn.measurement)) --waiting_frames_;
  return turn;
}

void RealtimeQueue::Arrive(const Measurement& measurement) {
  waiting_.push_back(measurement);
  if (!IsFrame(measurement)) return;
  ++report_.frames;
  if (++waiting_frames_ <= config_.frame_queue) return;
  waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), IsFrame));
  --waiting_frames_;
  report_.drops.push_back(measurement.t_arrival);
}

std::vector<EstimatorEvent> DescribeDrops(const RealtimeReport& report) {
  std::vector<EstimatorEvent> events;
  for (auto first = report.drops.begin(); first != report.drops.end();) {
    const auto end = std::upper_bound(first, report.drops.end(), *first + kSecond);
    const auto count = end - first;
    const std::string what = count == 1 ? "a stereo frame dropped"
                                        : fmt::format("{} stereo frames dropped within 1 s", count);
    events.push_back({*first, what + ": the estimator was busy"});
    first = end;
  }
  return events;
}

}  // namespace drydock
