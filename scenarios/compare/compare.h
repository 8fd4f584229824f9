// Estimators side by side: each dive simulated once and fed to all of them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/compare/summary.h"
#include "sensors_models/base/time.h"
#include "sim/render/gl_context.h"

namespace drydock::compare {

struct CompareOptions {
  sim::RendererBackend renderer = sim::RendererBackend::kAuto;
  std::filesystem::path output;
  std::vector<std::string> overrides;  ///< "key.path=value" for the scenarios of all cases.
  /// Called before each dive; gives what is called now and then with simulated time and the end.
  std::function<std::function<void(Time now, Time end)>()> progress = [] {
    return [](Time, Time) {};
  };
  /// Takes a line for each dive: what was simulated, or found finished.
  std::function<void(const std::string& line)> report = [](const std::string&) {};
};

/// Simulates each case and seed of which not every estimator is finished, in lock step with those
/// that are not, each estimator on one thread. Keeps what is finished in output/finished and writes
/// comparison.md, comparison.json and timings.json in the end. InputError if something cannot be
/// used; nothing is written if that shows before the first dive.
///
/// What is finished is known by the resolved scenario, the rigs, the renderer asked for and this
/// very program: another build starts anew.
Comparison RunComparison(const Suite& suite, const CompareOptions& options);

}  // namespace drydock::compare
