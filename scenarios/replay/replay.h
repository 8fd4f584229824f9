// An estimator on a recording.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "estimator/registry/registry.h"
#include "scenarios/results/realtime_queue.h"
#include "scenarios/scoring/scorecard.h"
#include "sensors_models/base/time.h"
#include "sensors_models/base/yaml_node.h"

namespace drydock {

struct ReplayOptions {
  std::string estimator = "svin2";  ///< A registered name.
  /// What the estimator believes of the rig: a rig's name or file; by default the recording's own.
  std::string rig;
  /// A mapping that the estimator itself understands; empty for its defaults.
  YamlNode options = NoOptions();
  /// Start from the first state of the recording's ground truth.
  bool start_from_truth = false;
  /// The estimator takes the time that it takes, with the options that it has on a robot; results
  /// differ from run to run. Nothing: lock step.
  std::optional<RealtimeConfig> realtime;
  std::filesystem::path output;  ///< Replaced as a whole when everything is done.
  /// Called now and then with the time since the first arrival and that of the last one.
  std::function<void(Time now, Time end)> progress = [](Time, Time) {};
  /// Takes messages about what is odd but can be read.
  std::function<void(const std::string& message)> warn = [](const std::string&) {};
};

/// Where the wall-clock time of a replay went [s].
struct ReplayTimings {
  double reading = 0.0;  ///< Tables and images.
  double estimator = 0.0;
  double recorded = 0.0;  ///< From the first arrival to the last.
};

struct ReplayResult {
  std::size_t measurements = 0;
  std::size_t poses = 0;                      ///< Of the odometry.
  std::optional<score::Scorecard> scorecard;  ///< Where the recording has ground truth.
  ReplayTimings timings;
  std::optional<RealtimeReport> realtime;  ///< Nothing in lock step.
};

/// Hands the measurements of an EuRoC folder to an estimator in the order of their arrival and
/// writes odometry.tum, trajectory.tum, loops.csv, events.log, manifest.json and timings.json to
/// the output folder and, where the recording has ground truth, truth.tum, scorecard.json and
/// trajectory.png; the truth is interpolated at the estimate's stamps where it is dense enough.
/// What `run --record` recorded gives, in lock step, the odometry of that run again, byte for byte.
/// InputError if the recording, the rig or the options cannot be used; nothing is written then.
ReplayResult Replay(const std::filesystem::path& recording, const ReplayOptions& options);

}  // namespace drydock
