// `drydock run`: exit codes, and what is left behind. What it refuses is in
// broken_scenarios_test.cc.
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

}  // namespace
}  // namespace drydock::testing
