#include "scenarios/runner/run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scenarios/dataset/tum.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"

namespace drydock {
namespace {

Scenario Bus(const std::vector<std::string>& overrides) {
  return LoadScenario(DRYDOCK_SOURCE_DIR "/tests/data/dead_reckoning/bus.yaml", overrides);
}

const std::vector<std::string> kBlind = {"sensors={stereo: {enabled: false}}", "duration_s=15"};

TEST(Run, WritesEverything) {
  const testing::TemporaryFolder folder;
  RunOptions options;
  options.output = folder.path() / "run";
  options.record = true;
  const RunResult result = RunScenario(Bus({"duration_s=0.5"}), options);
  for (const char* name :
       {"scorecard.json", "timings.json", "manifest.json", "truth.tum", "odometry.tum",
        "trajectory.tum", "loops.csv", "events.log", "trajectory.png", "frames.png",
        "dataset/mav0/cam0/data.csv", "dataset/mav0/sonar0/data.csv"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(options.output / name)) << name;
  }
  const auto card = nlohmann::json::parse(ReadFile(options.output / "scorecard.json"));
  EXPECT_EQ(card["schema"], 1);
  EXPECT_EQ(card["scenario"], "bus");
  EXPECT_EQ(card["estimator"], "dead-reckoning");
  const auto manifest = nlohmann::json::parse(ReadFile(options.output / "manifest.json"));
  EXPECT_EQ(manifest["config_hash"], card["config_hash"]);
  EXPECT_GT(result.timings.sensors, 0.0);
}

// Everything noise-free, from the true start: what is left is the integration at 100 Hz.
TEST(Run, NoiseFreeDeadReckoningStaysOnTheTruth) {
  const testing::TemporaryFolder folder;
  RunOptions options;
  options.output = folder.path() / "run";
  const RunResult result = RunScenario(
      Bus({"sensors={stereo: {enabled: false}, imu: {noise: false}, depth: {noise: false}}",
           "duration_s=15"}),
      options);
  EXPECT_LT(*result.scorecard.metrics.ate_rmse_m, 0.002);
  EXPECT_LT(*result.scorecard.metrics.final_drift_percent, 0.1);
}

TEST(Run, DepthHoldsTheHeightOfDeadReckoning) {
  const testing::TemporaryFolder folder;
  for (const std::uint64_t seed : {1, 2, 3}) {
    Scenario scenario = Bus(kBlind);
    scenario.seed = seed;
    RunOptions options;
    options.output = folder.path() / "run";
    const RunResult result = RunScenario(scenario, options);
    EXPECT_LT(*result.scorecard.metrics.z_rmse_m, 0.02);
    EXPECT_EQ(*result.scorecard.metrics.continuity_percent, 100.0);
    EXPECT_TRUE(result.scorecard.Passed());
  }
}

TEST(Run, AMissedCriterionFails) {
  const testing::TemporaryFolder folder;
  Scenario scenario = Bus(kBlind);
  scenario.criteria = {{"ate_rmse_m", std::nullopt, 1e-9}};
  RunOptions options;
  options.output = folder.path() / "run";
  EXPECT_FALSE(RunScenario(scenario, options).scorecard.Passed());
}

TEST(Run, AnEstimatorThatCannotStartLeavesNothing) {
  const testing::TemporaryFolder folder;
  RunOptions options;
  options.output = folder.path() / "run";
  std::vector<std::string> overrides = kBlind;
  overrides.emplace_back("estimator.start_from_truth=false");
  EXPECT_THROW(RunScenario(Bus(overrides), options), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace drydock
