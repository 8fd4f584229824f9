#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scenarios/replay/replay.h"
#include "tools/drydock/commands.h"
#include "tools/drydock/print_metrics.h"
#include "tools/drydock/progress.h"
#include "tools/drydock/realtime_arguments.h"

namespace drydock::cli {
namespace {

struct Arguments {
  std::string recording;
  std::string output;
  std::vector<std::string> assignments;
  ReplayOptions options;
  RealtimeArguments realtime;
};

int EstimateCommand(Arguments arguments) {
  ReplayOptions& options = arguments.options;
  options.output = arguments.output;
  options.realtime = arguments.realtime.Config();
  for (const std::string& assignment : arguments.assignments) SetYaml(options.options, assignment);
  options.progress = ProgressOnTerminal();
  options.warn = [](const std::string& message) {
    fmt::print(stderr, "drydock: warning: {}\n", message);
  };
  const ReplayResult result = Replay(arguments.recording, options);
  fmt::print("{}: {} measurements in {:.1f} s, {} poses\n", options.estimator, result.measurements,
             result.timings.recorded, result.poses);
  if (result.scorecard) PrintMetrics(result.scorecard->metrics);
  PrintRealtime(result.realtime);
  const double work = result.timings.reading + result.timings.estimator;
  if (work > 0.0) fmt::print("{:.2f} x real time\n", result.timings.recorded / work);
  fmt::print("results in {}: odometry.tum, trajectory.tum{}\n", arguments.output,
             result.scorecard ? ", scorecard.json, trajectory.png" : "");
  return kPassed;
}

}  // namespace

void AddEstimateCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "estimate", "Run an estimator on a recorded dataset; score it where the truth is known");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("dataset", arguments->recording,
                   "EuRoC folder, recorded by Drydock or by others: mav0 or what holds it")
      ->required();
  command->add_option("--estimator", arguments->options.estimator, "Estimator (see drydock list)")
      ->capture_default_str();
  command
      ->add_option("--set", arguments->assignments,
                   "key.path=value: an option of the estimator; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--rig", arguments->options.rig,
                      "What the estimator believes of the rig: a rig's name or a .yaml file "
                      "[the dataset's own]");
  command->add_flag("--start-from-truth", arguments->options.start_from_truth,
                    "Tell the estimator the first state of the dataset's ground truth");
  AddRealtimeOptions(*command, arguments->realtime);
  command
      ->add_option("-o,--output", arguments->output,
                   "Folder for the results, replaced if it is there")
      ->required();
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return EstimateCommand(*arguments); }; });
}

}  // namespace drydock::cli
