// The first seconds of each of the paper's dives, from a start of the estimator's own.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scenarios/runner/run.h"
#include "tests/support/temporary_folder.h"

namespace drydock {
namespace {

constexpr double kSeconds = 15.0;

class Dives : public ::testing::TestWithParam<std::string> {};

TEST_P(Dives, AreFollowedFromTheStart) {
  const testing::TemporaryFolder folder;
  Scenario scenario = LoadScenario(DRYDOCK_SOURCE_DIR "/scenarios/" + GetParam() + ".yaml",
                                   {"seed=7", "duration_s=" + std::to_string(kSeconds)});
  RunOptions options;
  options.output = folder.path() / "run";
  const RunResult result = RunScenario(scenario, options);
  const score::Metrics& metrics = result.scorecard.metrics;
  ASSERT_TRUE(metrics.ate_rmse_m.has_value());
  // Some 6 m of way; over so little the noise of single frames counts.
  EXPECT_LT(*metrics.ate_rmse_m, 0.03);
  EXPECT_EQ(metrics.continuity_percent, 100.0);
  EXPECT_LT(*metrics.init_time_s, 3.0);
  EXPECT_LT(std::abs(*metrics.scale_error_percent), 0.5);
  EXPECT_EQ(metrics.sonar_map_rmse_m.has_value(), GetParam() != "cemetery");
  if (metrics.sonar_map_rmse_m) {
    EXPECT_LT(*metrics.sonar_map_rmse_m, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Dives, ::testing::Values("bus", "cavern1", "cavern2", "cemetery"),
                         [](const auto& which) { return which.param; });

}  // namespace
}  // namespace drydock
