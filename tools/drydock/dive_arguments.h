// What every sub-command that simulates a dive takes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scenarios/runner/run.h"

namespace drydock::cli {

struct DiveArguments {
  std::string scenario;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> overrides;
  std::string renderer = "auto";

  /// The scenario as asked for; InputError as LoadScenario.
  Scenario Load() const;
  /// Renderer and progress; the output folder is left to the caller.
  RunOptions Options() const;
};

/// Adds the options to `command`; `arguments` must live until they are parsed.
void AddDiveOptions(CLI::App& command, DiveArguments& arguments);

}  // namespace drydock::cli
