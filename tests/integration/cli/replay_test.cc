// What `drydock run --record` recorded gives the same odometry again, to the last byte.
#include <gtest/gtest.h>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

// Latencies mix the order of arrival; the noise makes every bit count.
TEST(CliReplay, GivesTheOdometryOfTheRun) {
  const TemporaryFolder folder;
  const Outcome run = RunDrydock(
      folder.path(),
      {"run", BusScenario(), "--set", "duration_s=3", "--set",
       "sensors={stereo: {enabled: false}, depth: {latency_s: 0.13}, sonar: {latency_s: 0.02}}",
       "--seed", "5", "--record", "-o", "run"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Outcome estimate =
      RunDrydock(folder.path(), {"estimate", "run/dataset", "--estimator", "dead-reckoning",
                                 "--start-from-truth", "-o", "estimate"});
  ASSERT_EQ(estimate.exit_code, 0) << estimate.err;
  for (const char* name : {"odometry.tum", "trajectory.tum", "loops.csv", "events.log"}) {
    const std::string once = ReadFile(folder.path() / "run" / name);
    EXPECT_GT(once.size(), 20U) << name;
    EXPECT_TRUE(ReadFile(folder.path() / "estimate" / name) == once) << name;
  }
}

// With pictures, from the recording that `simulate` makes of the same scenario.
TEST(CliReplay, SimulateAndEstimateIsRun) {
  const TemporaryFolder folder;
  const std::vector<std::string> dive = {BusScenario(), "--set", "duration_s=0.5"};
  const auto with = [&](const std::string& command, const std::string& output) {
    std::vector<std::string> all = {command, "-o", output};
    all.insert(all.end(), dive.begin(), dive.end());
    const Outcome outcome = RunDrydock(folder.path(), all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  with("run", "run");
  with("simulate", "dataset");
  const Outcome estimate =
      RunDrydock(folder.path(), {"estimate", "dataset", "--estimator", "dead-reckoning",
                                 "--start-from-truth", "-o", "estimate"});
  ASSERT_EQ(estimate.exit_code, 0) << estimate.err;
  EXPECT_TRUE(ReadFile(folder.path() / "run" / "odometry.tum") ==
              ReadFile(folder.path() / "estimate" / "odometry.tum"));
}

// The whole of SVIn2, from its own initialisation on: run twice, and from the recording.
TEST(CliReplay, Svin2GivesTheSameBytesAgain) {
  const TemporaryFolder folder;
  const std::vector<std::string> dive = {std::string(DRYDOCK_SOURCE_DIR) + "/scenarios/bus.yaml",
                                         "--set", "duration_s=3", "--set", "criteria=[]"};
  const auto run = [&](const std::string& output) {
    std::vector<std::string> all = {"run", "--record", "-o", output};
    all.insert(all.end(), dive.begin(), dive.end());
    const Outcome outcome = RunDrydock(folder.path(), all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  run("run");
  run("again");
  const Outcome estimate = RunDrydock(
      folder.path(), {"estimate", "run/dataset", "--estimator", "svin2", "-o", "estimate"});
  ASSERT_EQ(estimate.exit_code, 0) << estimate.err;
  for (const char* name : {"odometry.tum", "trajectory.tum", "events.log"}) {
    const std::string once = ReadFile(folder.path() / "run" / name);
    EXPECT_GT(once.size(), 200U) << name;
    EXPECT_TRUE(ReadFile(folder.path() / "again" / name) == once) << name;
    EXPECT_TRUE(ReadFile(folder.path() / "estimate" / name) == once) << name;
  }
}

}  // namespace
}  // namespace drydock::testing
