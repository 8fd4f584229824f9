// `drydock run --realtime`: how much is lost depends on the machine, what is written does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class CliRealtime : public ::testing::Test {
 protected:
  Outcome Run(const std::vector<std::string>& options) const {
    std::vector<std::string> all = {
        "run",   std::string(DRYDOCK_SOURCE_DIR) + "/scenarios/bus.yaml",
        "--set", "duration_s=3",
        "--set", "criteria=[]",
        "-o",    "result"};
    all.insert(all.end(), options.begin(), options.end());
    return RunDrydock(folder_.path(), all);
  }
  nlohmann::json Json(const std::string& name) const {
    return nlohmann::json::parse(ReadFile(folder_.path() / "result" / name));
  }

  const TemporaryFolder folder_;
};

TEST_F(CliRealtime, SaysWhatTheEstimatorMissed) {
  const Outcome run = Run({"--realtime"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, ContainsRegex("in real time: [0-9]+ of 46 stereo frames dropped"));
  const auto manifest = Json("manifest.json");
  EXPECT_EQ(manifest["realtime"], true);
  EXPECT_THAT(std::string(manifest["scenario"]), HasSubstr("solver_time_s: 0.03\n"));
  const auto timings = Json("timings.json");
  const int dropped = manifest["frames_dropped"];
  EXPECT_EQ(timings["realtime"]["frames_dropped"], dropped);
  EXPECT_EQ(timings["realtime"]["frames"], 46);
  EXPECT_EQ(timings["estimator_stages"]["front end"]["count"], 46 - dropped);
  EXPECT_FALSE(Json("scorecard.json").contains("realtime"));
}

// What the user says counts, and what the options leave unsaid stays unsaid.
TEST_F(CliRealtime, KeepsTheSolversTimeThatIsGiven) {
  const Outcome run = Run({"--realtime", "--frame-queue", "2", "--set",
                           "estimator.options={window: {solver_time_s: 0.001, keyframes: 4}}"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string scenario = Json("manifest.json")["scenario"];
  EXPECT_THAT(scenario, HasSubstr("solver_time_s: 0.001\n"));
  EXPECT_THAT(scenario, HasSubstr("keyframes: 4\n"));
}

// Dead reckoning keeps up anywhere and has no options: it gives what it gives in lock step.
TEST_F(CliRealtime, AFastEstimatorMissesNothing) {
  const std::vector<std::string> blind = {"--set",       "sensors={stereo: {enabled: false}}",
                                          "--estimator", "dead-reckoning",
                                          "--set",       "estimator.start_from_truth=true"};
  const auto odometry_of = [&](bool realtime) {
    std::vector<std::string> options = blind;
    if (realtime) options.emplace_back("--realtime");
    const Outcome run = Run(options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return ReadFile(folder_.path() / "result" / "odometry.tum");
  };
  const std::string lock_step = odometry_of(false);
  EXPECT_EQ(Json("manifest.json")["realtime"], false);
  EXPECT_FALSE(Json("manifest.json").contains("frames_dropped"));
  EXPECT_FALSE(Json("timings.json").contains("realtime"));
  EXPECT_TRUE(odometry_of(true) == lock_step);
  EXPECT_EQ(Json("manifest.json")["realtime"], true);
}

TEST_F(CliRealtime, HelpSaysThatItIsNotReproducible) {
  const Outcome help = RunDrydock(folder_.path(), {"run", "--help"});
  EXPECT_THAT(help.out, ContainsRegex("--realtime .*no longer reproducible"));
}

TEST_F(CliRealtime, RefusesAQueueThatMakesNoSense) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--frame-queue", "2"}, {"--realtime", "--frame-queue", "0"}}) {
    const Outcome run = Run(options);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("--frame-queue"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "result"));
  }
}

}  // namespace
}  // namespace drydock::testing
