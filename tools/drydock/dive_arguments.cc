#include "tools/drydock/dive_arguments.h"

#include <fmt/format.h>

#include "tools/drydock/progress.h"

namespace drydock::cli {

Scenario DiveArguments::Load() const {
  std::vector<std::string> all = overrides;
  if (seed) all.push_back(fmt::format("seed={}", *seed));
  return LoadScenario(scenario, all);
}

RunOptions DiveArguments::Options() const {
  RunOptions options;
  options.renderer = sim::ParseRendererBackend(renderer);
  options.progress = ProgressOnTerminal();
  return options;
}

void AddDiveOptions(CLI::App& command, DiveArguments& arguments) {
  command.add_option("scenario", arguments.scenario, "Scenario file (scenarios/bus.yaml)")
      ->required();
  command.add_option("--seed", arguments.seed,
                     "Seed of noise, biases and sway, instead of the scenario's");
  command
      .add_option("--set", arguments.overrides,
                  "key.path=value: overrides a key of the scenario; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--renderer", arguments.renderer, "auto, egl or osmesa")
      ->capture_default_str();
}

}  // namespace drydock::cli
