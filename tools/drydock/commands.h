// The sub-commands of `drydock`, one file each.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace drydock::cli {

/// Exit codes.
inline constexpr int kPassed = 0;
inline constexpr int kMissed = 1;  ///< A criterion was missed.
inline constexpr int kCouldNotRun = 2;

/// Each adds its sub-command to `app`; `chosen` is set to what it does if the user picks it.
using Action = std::function<int()>;
void AddRunCommand(CLI::App& app, Action& chosen);
void AddSimulateCommand(CLI::App& app, Action& chosen);
void AddEstimateCommand(CLI::App& app, Action& chosen);
void AddCompareCommand(CLI::App& app, Action& chosen);
void AddScoreCommand(CLI::App& app, Action& chosen);
void AddListCommand(CLI::App& app, Action& chosen);

}  // namespace drydock::cli
