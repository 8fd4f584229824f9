// The files that an estimator leaves behind, whether its measurements were simulated or recorded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "estimator/interface/estimator.h"
#include "scenarios/results/realtime_queue.h"
#include "scenarios/scoring/consistency.h"
#include "scenarios/scoring/scorecard.h"

namespace drydock {

/// What an estimator said, and what happened to it.
struct Results {
  Trajectory odometry;   ///< As published at the time.
  Trajectory corrected;  ///< As known in the end.
  std::vector<LoopClosure> loops;
  EstimatedMap map;  ///< In the W of `corrected`.
  std::vector<std::string> events;
  EstimatorTimings stages;
  std::vector<score::Belief> beliefs;      ///< Published poses that came with a covariance.
  std::optional<int> false_starts;         ///< Nothing if the estimator never started.
  std::optional<RealtimeReport> realtime;  ///< Nothing in lock step.
};

/// The metrics that need more than trajectories, but no more than the true one to judge by.
score::Metrics KnownMetrics(const Trajectory& truth, const Results& results);

/// Writes odometry.tum, trajectory.tum, loops.csv and events.log into `folder`.
void WriteResults(const std::filesystem::path& folder, const Results& results);

/// Writes truth.tum, scorecard.json and, where `trajectory` can be laid upon the truth,
/// trajectory.png with `title`.
void WriteScore(const std::filesystem::path& folder, const std::string& title,
                const Trajectory& truth, const Trajectory& trajectory,
                const score::Scorecard& card);

/// Sixteen hexadecimal digits that identify a text: 64-bit FNV-1a.
std::string HashText(std::string_view text);

}  // namespace drydock
