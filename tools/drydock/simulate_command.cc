#include <memory>
#include <string>

#include <fmt/format.h>

#include "tools/drydock/commands.h"
#include "tools/drydock/dive_arguments.h"

namespace drydock::cli {
namespace {

struct Arguments {
  DiveArguments dive;
  std::string output;
};

int SimulateCommand(const Arguments& arguments) {
  const Scenario scenario = arguments.dive.Load();
  RunOptions options = arguments.dive.Options();
  options.output = arguments.output;
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
  AddDiveOptions(*command, arguments->dive);
  command
      ->add_option("-o,--output", arguments->output,
                   "Folder for the dataset, replaced if it is there")
      ->required();
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return SimulateCommand(*arguments); }; });
}

}  // namespace drydock::cli
