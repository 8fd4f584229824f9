#include <memory>
#include <string>

#include <fmt/format.h>

#include "scenarios/dataset/tum.h"
#include "scenarios/scoring/json.h"
#include "scenarios/scoring/trajectory_score.h"
#include "sensors_models/base/check.h"
#include "tools/drydock/commands.h"
#include "tools/drydock/print_metrics.h"

namespace drydock::cli {
namespace {

struct Arguments {
  std::string truth;
  std::string estimate;
  std::string align = "se3";
  bool interpolate = false;
  bool json = false;
};

Trajectory ReadPoses(const std::string& file) {
  Trajectory trajectory = dataset::ReadTum(file);
  RequireInput(!trajectory.empty(), "{}: holds no poses", file);
  return trajectory;
}

score::TrajectoryScore Compare(const Arguments& arguments) {
  score::AssociationOptions association;
  if (arguments.interpolate) association.mode = score::AssociationMode::kInterpolate;
  const Trajectory truth = ReadPoses(arguments.truth);
  const Trajectory estimate = ReadPoses(arguments.estimate);
  try {
    return score::ScoreTrajectories(truth, estimate, score::ParseAlignment(arguments.align),
                                    association);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{} against {}: {}", arguments.estimate, arguments.truth, error.what()));
  }
}

int ScoreFiles(const Arguments& arguments) {
  const score::TrajectoryScore result = Compare(arguments);
  if (arguments.json) {
    fmt::print("{}", score::ToJson(result));
    return kPassed;
  }
  fmt::print("{} pairs, aligned by {}, path {:.2f} m\n", result.association.pairs.size(),
             arguments.align, result.path_length_m);
  PrintMetrics(result.metrics);
  return kPassed;
}

}  // namespace

void AddScoreCommand(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("score", "Score an estimated trajectory against the true one (TUM files)");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("truth", arguments->truth, "True trajectory, TUM format")->required();
  command->add_option("estimate", arguments->estimate, "Estimated trajectory, TUM format")
      ->required();
  command->add_option("--align", arguments->align, "How the estimate is laid upon the truth")
      ->check(CLI::IsMember({"none", "origin", "yaw", "se3", "sim3"}))
      ->capture_default_str();
  command->add_flag("--interpolate", arguments->interpolate,
                    "Interpolate the truth at the estimate's times rather than take the nearest "
                    "pose within 0.01 s");
  command->add_flag("--json", arguments->json, "Everything as JSON");
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return ScoreFiles(*arguments); }; });
}

}  // namespace drydock::cli
