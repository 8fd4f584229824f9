// `drydock run`: exit codes, and what is left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Without pictures a dive of some seconds takes a fraction of one.
const std::string kBlind = "sensors={stereo: {enabled: false}}";

TEST(CliRun, MetCriteriaExitWithZero) {
  const TemporaryFolder folder;
  const Outcome run = RunDrydock(
      folder.path(), {"run", BusScenario(), "--set", "duration_s=0.5", "--record", "-o", "result"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, ContainsRegex("met +continuity_percent >= 99 %"));
  EXPECT_THAT(run.out, HasSubstr("results in result: "));
  EXPECT_THAT(run.out, HasSubstr("PASSED\n"));
  for (const char* name : {"scorecard.json", "truth.tum", "odometry.tum", "trajectory.tum",
                           "loops.csv", "events.log", "manifest.json", "timings.json",
                           "trajectory.png", "frames.png", "dataset/mav0/imu0/data.csv"}) {
    EXPECT_TRUE(fs::is_regular_file(folder.path() / "result" / name)) << name;
  }
}

TEST(CliRun, AMissedCriterionExitsWithOne) {
  const TemporaryFolder folder;
  const Outcome run = RunDrydock(folder.path(), {"run", BusScenario(), "--set", kBlind, "--set",
                                                 "duration_s=2", "--set", "criteria.1.max=1e-9"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("MISSED +z_rmse_m <= 1e-09 m"));
  EXPECT_THAT(run.out, HasSubstr("FAILED\n"));
  EXPECT_TRUE(fs::is_regular_file(folder.path() / "out" / "bus" / "scorecard.json"));
}

struct Refusal {
  const char* name;
  std::vector<std::string> arguments;
  const char* says;  ///< A regular expression.
};

class CliRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(CliRefusal, ExitsWithTwoSaysWhyAndLeavesNothing) {
  const TemporaryFolder scenarios, folder;
  WriteFileAtomically(scenarios.path() / "unknown_key.yaml",
                      "base: " + BusScenario() + "\ncurrents: strong\n");
  WriteFileAtomically(scenarios.path() / "unknown_scene.yaml",
                      "base: " + BusScenario() + "\nscene:\n  name: atlantis\n");
  WriteFileAtomically(scenarios.path() / "not_yaml.yaml", "summary: [\n");
  std::vector<std::string> arguments = {"run", "-o", "result"};
  for (std::string argument : GetParam().arguments) {
    if (argument.ends_with(".yaml")) argument = (scenarios.path() / argument).string();
    arguments.push_back(std::move(argument));
  }
  const Outcome run = RunDrydock(folder.path(), arguments);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, ContainsRegex(GetParam().says));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

const Refusal kRefusals[] = {
    {"MissingFile", {"nowhere.yaml"}, "nowhere\\.yaml: no such file"},
    {"BrokenYaml", {"not_yaml.yaml"}, "not_yaml\\.yaml:[0-9]+: "},
    {"UnknownKey", {"unknown_key.yaml"}, "unknown_key\\.yaml:2: unknown key 'currents'"},
    {"UnknownScene",
     {"unknown_scene.yaml"},
     "unknown_scene\\.yaml:3: scene\\.name is atlantis, must be one of .*bus"},
    {"UnknownEstimator",
     {BusScenario(), "--estimator", "crystal-ball"},
     "estimator\\.name is crystal-ball, must be one of .*dead-reckoning"},
    {"UnknownRenderer",
     {BusScenario(), "--renderer", "crayons"},
     "renderer is crayons, must be one of auto, egl, osmesa"},
    {"UnknownOverride", {BusScenario(), "--set", "depth=3"}, "--set depth=3: unknown key 'depth'"},
    {"OverrideOutOfBounds",
     {BusScenario(), "--set", "water.visibility_m=-1"},
     "--set water\\.visibility_m=-1: water\\.visibility_m is -1"},
    {"ImpossibleCriterion",
     {BusScenario(), "--set", "criteria.0.max=-1"},
     "bus\\.yaml:[0-9]+: criteria\\.0"},
    {"PathTouchesTheScene",
     {BusScenario(), "--set", "motion.waypoints.2.position_m=[4.5, -2, 0]"},
     "the path at \\([0-9., -]+\\) m comes within [0-9.]+ m of 'bus_"},
};

INSTANTIATE_TEST_SUITE_P(All, CliRefusal, ::testing::ValuesIn(kRefusals),
                         [](const auto& refusal) { return std::string(refusal.param.name); });

}  // namespace
}  // namespace drydock::testing
