// One run: simulate, estimate in the loop, score.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/results/realtime_queue.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/scoring/scorecard.h"
#include "sim/render/gl_context.h"

namespace drydock {

struct RunOptions {
  sim::RendererBackend renderer = sim::RendererBackend::kAuto;
  std::filesystem::path output;  ///< Replaced as a whole when the run is complete.
  bool record = false;           ///< Keep the dataset in output/dataset.
  /// The estimator takes the time that it takes, with the options that it has on a robot; results
  /// differ from run to run. Nothing: lock step.
  std::optional<RealtimeConfig> realtime;
  /// Called now and then with simulated time and the dive's end.
  std::function<void(Time now, Time end)> progress = [](Time, Time) {};
};

/// Where the wall-clock time of a run went [s].
struct RunTimings {
  double setup = 0.0;  ///< Scene, meshes, textures, OpenGL.
  double sensors = 0.0;
  double estimator = 0.0;
  double recording = 0.0;
  double simulated = 0.0;  ///< Length of the dive.
};

struct RunResult {
  score::Scorecard scorecard;
  RunTimings timings;
  std::optional<RealtimeReport> realtime;  ///< Nothing in lock step.
};

/// Runs `scenario` and writes scorecard.json, timings.json, manifest.json, truth.tum,
/// odometry.tum, trajectory.tum, loops.csv, events.log, trajectory.png and frames.png to the output
/// folder. InputError if it cannot run.
RunResult RunScenario(const Scenario& scenario, const RunOptions& options);

/// Simulates and records only. `output` appears when the recording is complete.
RunTimings RecordScenario(const Scenario& scenario, const RunOptions& options);

}  // namespace drydock
