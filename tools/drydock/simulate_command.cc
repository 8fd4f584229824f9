#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scenarios/runner/run.h"
#include "tools/drydock/commands.h"
#include "tools/drydock/progress.h"

namespace drydock::cli {
namespace {

struct Arguments {
  std::string scenario;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> overrides;
  std::string renderer = "auto";
  std::string output;
};

int SimulateCommand(const Arguments& arguments) {
  std::vector<std::string> overrides = arguments.overrides;
  if (arguments.seed) overrides.push_back(fmt::format("seed={}", *arguments.seed));
  const Scenario scenario = LoadScenario(arguments.scenario, overrides);
  RunOptions options;
  options.renderer = sim::ParseRendererBackend(arguments.renderer);
  options.output = arguments.output;
  options.progress = ProgressOnTerminal();
  const RunTimings timings = RecordScenario(scenario, options);
  fmt::print("{}: {:.1f} s simulated at {:.2f} x real time ({:.1f} s of set-up not counted)\n",
             scenario.name, timings.simulated,
             timings.simulated / (timings.sensors + timings.recording), timings.setup);
  fmt::print("dataset in {}/mav0\n", arguments.output);
  return kPassed;
}

}  // namespace

void AddSimulateCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Record a scenario's measurements and truth as an EuRoC dataset");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("scenario", arguments->scenario, "Scenario file (scenarios/bus.yaml)")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "Folder for the dataset, replaced if it is there")
      ->required();
  command->add_option("--seed", arguments->seed,
                      "Seed of noise, biases and sway, instead of the scenario's");
  command
      ->add_option("--set", arguments->overrides,
                   "key.path=value: overrides a key of the scenario; may be repeated")
      ->take_all();
  command->add_option("--renderer", arguments->renderer, "auto, egl or osmesa")
      ->capture_default_str();
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return SimulateCommand(*arguments); }; });
}

}  // namespace drydock::cli
