// The files of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "estimator/interface/estimator.h"
#include "scenarios/report/contact_sheet.h"
#include "scenarios/runner/dive.h"
#include "scenarios/runner/run.h"

namespace drydock {

/// Identifies the configuration: a hash of the resolved scenario and of the rigs that it names.
std::string ConfigHash(const Scenario& scenario);

/// All but scorecard and timings of a run, ready to be written.
struct RunFiles {
  Trajectory truth;
  Trajectory odometry;
  Trajectory corrected;
  std::vector<LoopClosure> loops;
  std::vector<std::string> events;
  std::vector<report::SheetFrame> frames;
};

void WriteRunFiles(const std::filesystem::path& folder, const Scenario& scenario, const Dive& dive,
                   const RunFiles& files, const RunResult& result);

}  // namespace drydock
