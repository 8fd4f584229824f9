// `drydock estimate --realtime` on a recording whose odometry is known by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/integration/cli/recording.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

using ::testing::ContainsRegex;

// Dead reckoning looks at no frames: it may miss some on a busy machine, and nothing else.
TEST(CliRealtimeEstimate, GivesTheOdometryOfLockStep) {
  const TemporaryFolder folder;
  RecordGlide(folder.path() / "glide");
  const auto estimate = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {"estimate",           "glide", "--estimator", "dead-reckoning",
                                    "--start-from-truth", "-o",    "result"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = RunDrydock(folder.path(), all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const auto read = [&](const char* name) { return ReadFile(folder.path() / "result" / name); };
  estimate({});
  const std::string lock_step = read("odometry.tum");
  EXPECT_EQ(nlohmann::json::parse(read("manifest.json"))["realtime"], false);
  EXPECT_THAT(estimate({"--realtime"}), ContainsRegex("in real time: [0-9] of 6 stereo frames"));
  EXPECT_EQ(read("odometry.tum"), lock_step);
  EXPECT_EQ(nlohmann::json::parse(read("manifest.json"))["realtime"], true);
  EXPECT_EQ(nlohmann::json::parse(read("timings.json"))["realtime"]["frames"], 6);
}

TEST(CliRealtimeEstimate, GivesSvin2ALimitOfTime) {
  const TemporaryFolder folder;
  RecordGlide(folder.path() / "glide");
  const Outcome outcome = RunDrydock(folder.path(), {"estimate", "glide", "--estimator",
                                                     "svin2-vio", "--realtime", "-o", "result"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto manifest = nlohmann::json::parse(ReadFile(folder.path() / "result" / "manifest.json"));
  EXPECT_EQ(manifest["options"], "window:\n  solver_time_s: 0.03\n");
}

}  // namespace
}  // namespace drydock::testing
