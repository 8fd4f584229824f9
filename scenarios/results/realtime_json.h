// How an estimator kept up, for manifest.json and timings.json.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "scenarios/results/realtime_queue.h"

namespace drydock {

/// "realtime": true with "frames_dropped", or false after a run in lock step.
inline void NoteRealtime(const std::optional<RealtimeReport>& report,
                         nlohmann::ordered_json& manifest) {
  manifest["realtime"] = report.has_value();
  if (report) manifest["frames_dropped"] = report->drops.size();
}

/// {"frames": …, "frames_dropped": …, "longest_wait_s": …}
inline nlohmann::ordered_json RealtimeJson(const RealtimeReport& report) {
  return {{"frames", report.frames},
          {"frames_dropped", report.drops.size()},
          {"longest_wait_s", report.longest_wait.Seconds()}};
}

}  // namespace drydock
