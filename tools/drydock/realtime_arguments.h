// What every sub-command takes in which one estimator works.
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "scenarios/results/realtime_queue.h"

namespace drydock::cli {

struct RealtimeArguments {
  bool realtime = false;
  RealtimeConfig config;

  std::optional<RealtimeConfig> Config() const {
    return realtime ? std::optional(config) : std::nullopt;
  }
};

/// Adds the options to `command`; `arguments` must live until they are parsed.
void AddRealtimeOptions(CLI::App& command, RealtimeArguments& arguments);

/// Prints how the estimator kept up, if it had to.
void PrintRealtime(const std::optional<RealtimeReport>& report);

}  // namespace drydock::cli
