// `drydock compare`: what it writes, what it keeps, and that it is `drydock run`, several times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string kBlind = "sensors={stereo: {enabled: false}}";

class CliCompare : public ::testing::Test {
 protected:
  Outcome Drydock(const std::vector<std::string>& arguments) const {
    return RunDrydock(folder_.path(), arguments);
  }
  /// Two seconds without pictures.
  Outcome Compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    for (const std::string& assignment : {kBlind, std::string("duration_s=2")}) {
      arguments.emplace_back("--set");
      arguments.push_back(assignment);
    }
    return Drydock(arguments);
  }
  nlohmann::json Json(const std::string& name) const {
    return nlohmann::json::parse(ReadFile(folder_.path() / name));
  }
  std::size_t Finished(const std::string& output) const {
    const fs::path folder = folder_.path() / output / "finished";
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  const TemporaryFolder folder_;
};

const std::vector<std::string> kOfTwoSeeds = {
    BusScenario(), "--estimators", "dead-reckoning", "--seeds", "2", "--first-seed", "4"};

TEST_F(CliCompare, HasTheFiguresOfRunsAndGoesOnWhereItStopped) {
  const Outcome first = Compare(kOfTwoSeeds);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.err, "");
  EXPECT_THAT(first.out, HasSubstr("bus, seed 5: 1 of 1 estimators simulated\n"));
  EXPECT_THAT(first.out, HasSubstr("| dead-reckoning |"));
  EXPECT_EQ(Finished("out/compare"), 2U);
  EXPECT_TRUE(fs::is_regular_file(folder_.path() / "out/compare/timings.json"));
  EXPECT_THAT(first.out, HasSubstr(ReadFile(folder_.path() / "out/compare/comparison.md")));

  const Outcome run = Drydock(
      {"run", BusScenario(), "--seed", "5", "--set", kBlind, "--set", "duration_s=2", "-o", "run"});
  ASSERT_NE(run.exit_code, 2) << run.err;
  const auto card = Json("run/scorecard.json");
  const auto compared = Json("out/compare/comparison.json");
  for (const auto& [name, metric] : compared["cases"][0]["estimators"][0]["metrics"].items())
    EXPECT_EQ(metric["values"][1], card["metrics"][name]) << name;

  const std::string before = ReadFile(folder_.path() / "out/compare/comparison.json");
  const Outcome again = Compare(kOfTwoSeeds);
  EXPECT_THAT(again.out, HasSubstr("bus, seed 4: finished before\nbus, seed 5: finished before\n"));
  EXPECT_EQ(ReadFile(folder_.path() / "out/compare/comparison.json"), before);

  std::vector<std::string> changed = kOfTwoSeeds;
  changed.insert(changed.end(), {"--set", "motion.speed_m_s=0.4"});
  EXPECT_THAT(Compare(changed).out, HasSubstr("bus, seed 4: 1 of 1 estimators simulated\n"));
  EXPECT_EQ(Finished("out/compare"), 4U);
}

TEST_F(CliCompare, ASuiteFeedsItsEstimatorsFromOneDive) {
  const auto suite = [&](const std::string& bound) {
    WriteFileAtomically(
        folder_.path() / "pair.yaml",
        "summary: Right and wrong\ncases:\n  - {name: dive, scenario: " + BusScenario() +
            ", seeds: [1], set: {motion.speed_m_s: 0.4}}\nestimators:\n"
            "  - {label: right, name: dead-reckoning}\n"
            "  - label: wrong\n    name: dead-reckoning\n"
            "    rig_set: {depth.position_m: [-5, 0, 0]}\n"
            "criteria:\n  - {case: dive, estimator: [right, wrong], metric: "
            "continuity_percent, min: " +
            bound + "}\n");
    return Compare({"--suite", "pair.yaml"});
  };
  const Outcome met = suite("99");
  EXPECT_EQ(met.exit_code, 0) << met.err;
  EXPECT_THAT(met.out, HasSubstr("dive, seed 1: 2 of 2 estimators simulated\n"));
  EXPECT_THAT(met.out, HasSubstr("\nPASSED\n"));
  const auto estimators = Json("out/pair/comparison.json")["cases"][0]["estimators"];
  EXPECT_EQ(estimators[0]["label"], "right");
  // A body that pitches moves a pressure port 5 m behind it by decimetres.
  const auto z = [&](int i) {
    return estimators[i]["metrics"]["z_rmse_m"]["median"].get<double>();
  };
  EXPECT_LT(z(0), 0.02);
  EXPECT_NE(z(1), z(0));

  const Outcome missed = suite("101");
  EXPECT_EQ(missed.exit_code, 1) << missed.err;
  EXPECT_THAT(missed.out, HasSubstr("dive, seed 1: finished before\n")) << "bounds change no run";
  EXPECT_THAT(missed.out, HasSubstr("| MISSED |"));
  EXPECT_THAT(missed.out, HasSubstr("\nFAILED\n"));
  EXPECT_EQ(Json("out/pair/comparison.json")["verdict"], "failed");
}

TEST_F(CliCompare, CountsStereoFrames) {
  const Outcome outcome = Drydock({"compare", BusScenario(), "--estimators", "dead-reckoning",
                                   "--seeds", "1", "--set", "duration_s=0.5", "-o", "frames"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("CPU time per stereo frame: dead-reckoning "));
  const auto costs = Json("frames/timings.json")["cases"][0]["estimators"]["dead-reckoning"][0];
  EXPECT_GT(costs["ms_per_frame"], 0.0);
}

}  // namespace
}  // namespace drydock::testing
