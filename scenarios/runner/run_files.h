// The files of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/report/contact_sheet.h"
#include "scenarios/results/result_files.h"
#include "scenarios/runner/dive.h"
#include "scenarios/runner/run.h"

namespace drydock {

/// Identifies the configuration: a hash of the resolved scenario and of the rigs that it names.
std::string ConfigHash(const Scenario& scenario);

/// All but scorecard and timings of a run, ready to be written.
struct RunFiles {
  Trajectory truth;
  Results results;
  std::vector<report::SheetFrame> frames;
};

void WriteRunFiles(const std::filesystem::path& folder, const Scenario& scenario, const Dive& dive,
                   const RunFiles& files, const RunResult& result);

}  // namespace drydock
