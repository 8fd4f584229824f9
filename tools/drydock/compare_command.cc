#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scenarios/compare/compare.h"
#include "scenarios/compare/suite_yaml.h"
#include "scenarios/compare/tables.h"
#include "sensors_models/base/check.h"
#include "tools/drydock/commands.h"
#include "tools/drydock/progress.h"

namespace drydock::cli {
namespace {

struct Arguments {
  std::vector<std::string> scenarios;
  std::vector<std::string> estimators;
  std::uint64_t seeds = 5;
  std::uint64_t first_seed = 1;
  std::string suite;
  std::string renderer = "auto";
  compare::CompareOptions options;
  std::string output;
};

compare::Suite SuiteOf(const Arguments& arguments) {
  if (!arguments.suite.empty()) return compare::LoadSuite(arguments.suite);
  RequireInput(!arguments.scenarios.empty(), "compare needs scenario files or --suite");
  RequireInput(!arguments.estimators.empty(), "compare needs --estimators or --suite");
  return compare::MakeSuite(arguments.scenarios, arguments.estimators, arguments.first_seed,
                            arguments.seeds);
}

int CompareCommand(Arguments arguments) {
  const compare::Suite suite = SuiteOf(arguments);
  compare::CompareOptions& options = arguments.options;
  options.output = arguments.output.empty() ? "out/" + suite.name : arguments.output;
  options.renderer = sim::ParseRendererBackend(arguments.renderer);
  options.progress = ProgressOnTerminal;
  options.report = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  const compare::Comparison comparison = compare::RunComparison(suite, options);
  fmt::print("\n{}\n", compare::ToMarkdown(comparison));
  const std::string costs = compare::DescribeCosts(comparison);
  if (!costs.empty()) fmt::print("CPU time per stereo frame: {}\n", costs);
  fmt::print("results in {}: comparison.md, comparison.json, timings.json\n",
             options.output.string());
  if (!comparison.criteria.empty()) fmt::print("{}\n", comparison.Passed() ? "PASSED" : "FAILED");
  return comparison.Passed() ? kPassed : kMissed;
}

void AddOptions(CLI::App& command, Arguments& arguments) {
  CLI::Option* suite = command.add_option("--suite", arguments.suite,
                                          "Suite file: dives, estimators with options, criteria");
  command.add_option("scenarios", arguments.scenarios, "Scenario files (scenarios/bus.yaml)")
      ->excludes(suite);
  command
      .add_option("--estimators", arguments.estimators,
                  "Estimators, separated by commas (see drydock list)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(suite);
  command.add_option("--seeds", arguments.seeds, "How many seeds each scenario is swum with")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000))
      ->excludes(suite);
  command.add_option("--first-seed", arguments.first_seed, "The first of them")
      ->capture_default_str()
      ->excludes(suite);
  command
      .add_option("--set", arguments.options.overrides,
                  "key.path=value: overrides a key of every scenario; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--renderer", arguments.renderer, "auto, egl or osmesa")
      ->capture_default_str();
  command.add_option("-o,--output", arguments.output,
                     "Folder for the results; what is finished there is kept [out/compare or "
                     "out/SUITE]");
}

}  // namespace

void AddCompareCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "compare", "Simulate dives over several seeds, once for all estimators; table of medians");
  const auto arguments = std::make_shared<Arguments>();
  AddOptions(*command, *arguments);
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return CompareCommand(*arguments); }; });
}

}  // namespace drydock::cli
