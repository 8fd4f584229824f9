#include <memory>
#include <string>

#include <fmt/format.h>

#include "tools/drydock/commands.h"
#include "tools/drydock/dive_arguments.h"
#include "tools/drydock/print_metrics.h"
#include "tools/drydock/realtime_arguments.h"

namespace drydock::cli {
namespace {

struct Arguments {
  DiveArguments dive;
  RealtimeArguments realtime;
  std::string estimator;
  std::string output;
  bool record = false;
};

void PrintScorecard(const score::Scorecard& card) {
  fmt::print("{}: seed {}, {}, path {:.2f} m in {:.1f} s\n", card.run.scenario, card.run.seed,
             card.run.estimator, card.path_length_m, card.duration_s);
  PrintMetrics(card.metrics);
  for (const score::CriterionResult& result : card.criteria) {
    fmt::print("  {} {} {} {}\n", result.passed ? "met   " : "MISSED", result.criterion.metric,
               score::DescribeBound(result.criterion), result.unit);
  }
}

int RunCommand(Arguments arguments) {
  if (!arguments.estimator.empty()) {
    arguments.dive.overrides.push_back(fmt::format("estimator.name={}", arguments.estimator));
  }
  const Scenario scenario = arguments.dive.Load();
  RunOptions options = arguments.dive.Options();
  options.output = arguments.output.empty() ? "out/" + scenario.name : arguments.output;
  options.record = arguments.record;
  options.realtime = arguments.realtime.Config();
  const RunResult result = RunScenario(scenario, options);
  PrintScorecard(result.scorecard);
  PrintRealtime(result.realtime);
  const RunTimings& timings = result.timings;
  const double work = timings.sensors + timings.estimator + timings.recording;
  fmt::print("{:.2f} x real time ({} renderer, {:.1f} s of set-up not counted)\n",
             timings.simulated / work, result.scorecard.run.renderer, timings.setup);
  fmt::print("results in {0}: scorecard.json, trajectory.png, frames.png\n",
             options.output.string());
  fmt::print("{}\n", result.scorecard.Passed() ? "PASSED" : "FAILED");
  return result.scorecard.Passed() ? kPassed : kMissed;
}

}  // namespace

void AddRunCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "run", "Simulate a scenario, estimate in the loop, score against the truth");
  const auto arguments = std::make_shared<Arguments>();
  AddDiveOptions(*command, arguments->dive);
  command->add_option("--estimator", arguments->estimator,
                      "Estimator, instead of the scenario's (see drydock list)");
  AddRealtimeOptions(*command, arguments->realtime);
  command->add_flag("--record", arguments->record,
                    "Keep the measurements, as an EuRoC dataset, in DIR/dataset");
  command->add_option("-o,--output", arguments->output,
                      "Folder for the results, replaced if it is there [out/SCENARIO]");
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return RunCommand(*arguments); }; });
}

}  // namespace drydock::cli
