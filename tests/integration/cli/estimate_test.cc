// `drydock estimate` on a recording whose odometry is known by hand.
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scenarios/dataset/tum.h"
#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/integration/cli/recording.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CliEstimate : public ::testing::Test {
 protected:
  CliEstimate() { RecordGlide(folder_.path() / "glide"); }

  Outcome Estimate(const std::vector<std::string>& options) const {
    std::vector<std::string> all = {"estimate",           "glide", "--estimator", "dead-reckoning",
                                    "--start-from-truth", "-o",    "result"};
    all.insert(all.end(), options.begin(), options.end());
    return RunDrydock(folder_.path(), all);
  }
  fs::path Result(const std::string& name) const { return folder_.path() / "result" / name; }
  nlohmann::json Json(const std::string& name) const {
    return nlohmann::json::parse(ReadFile(Result(name)));
  }

  const TemporaryFolder folder_;
};

TEST_F(CliEstimate, TakesSvin2UnlessItIsToldOtherwise) {
  EXPECT_THAT(RunDrydock(folder_.path(), {"estimate", "--help"}).out, HasSubstr("=svin2 "));
}

// After a second: 0.5 m/s * 1 s along x, 0.2 m/s^2 * (1 s)^2 / 2 along y, for which the midpoint
// rule is exact. The depth readings say what is believed already.
TEST_F(CliEstimate, GlidesWhereSpeedAndForceTakeIt) {
  const Outcome outcome = Estimate({});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Trajectory odometry = dataset::ReadTum(Result("odometry.tum"));
  ASSERT_EQ(odometry.size(), 21U);
  EXPECT_EQ(odometry.front().t.ns, 100'000'000'000);
  EXPECT_EQ(odometry.back().t.ns, 101'000'000'000);
  EXPECT_TRUE(odometry.front().T_WI.p().isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-12));
  EXPECT_TRUE(odometry.back().T_WI.p().isApprox(Eigen::Vector3d(1.5, 2.1, 3.0), 1e-12));
  EXPECT_EQ(ReadFile(Result("odometry.tum")), ReadFile(Result("trajectory.tum")));
}

TEST_F(CliEstimate, ScoresAgainstTheGroundTruth) {
  const Outcome outcome = Estimate({});
  EXPECT_THAT(outcome.out, HasSubstr("dead-reckoning: 40 measurements in 1.0 s, 21 poses"));
  EXPECT_THAT(outcome.out, HasSubstr("ate_rmse_m"));
  const auto card = Json("scorecard.json");
  EXPECT_EQ(card["scenario"], "glide");
  EXPECT_EQ(card["estimator"], "dead-reckoning");
  // The integral of sqrt(0.5^2 + (0.2 t)^2) over a second: 0.5 (1 + 0.16/6 - 0.16^2/40 + ...).
  EXPECT_NEAR(card["path_length_m"], 0.51301, 1e-4);
  EXPECT_NEAR(card["metrics"]["ate_rmse_m"], 0.0, 1e-9);
  EXPECT_EQ(card["metrics"]["continuity_percent"], 100.0);
  EXPECT_EQ(card["config_hash"], Json("manifest.json")["config_hash"]);
  EXPECT_EQ(Json("timings.json")["recorded_s"], 1.04);  // The last frame is 40 ms late.
  EXPECT_EQ(ReadFile(Result("events.log")), "0.000 s: dead reckoning, map 0\n");
  EXPECT_THAT(ReadFile(Result("loops.csv")), ::testing::StartsWith("#timestamp_now [ns]"));
  EXPECT_EQ(dataset::ReadTum(Result("truth.tum")).size(), 21U);
  EXPECT_TRUE(fs::is_regular_file(Result("trajectory.png")));
}

// Every true pose 20 ms late: of 20 estimates the truth tells the two poses around them.
TEST_F(CliEstimate, ScoresByTheTruthAtItsOwnStamps) {
  const fs::path table =
      folder_.path() / "glide" / "mav0" / "state_groundtruth_estimate0" / "data.csv";
  std::string text = ReadFile(table);
  text = std::regex_replace(text, std::regex("\n(1\\d{3})00000000,"), "\n$0120000000,");
  text = std::regex_replace(text, std::regex("\n(1\\d{3})50000000,"), "\n$0170000000,");
  WriteFileAtomically(table, text);
  const Outcome outcome = Estimate({});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Trajectory truth = dataset::ReadTum(Result("truth.tum"));
  ASSERT_EQ(truth.size(), 21U + 20U);
  EXPECT_EQ(truth[1].t.ns, 100'050'000'000);
  EXPECT_TRUE(truth[1].T_WI.p().isApprox(0.4 * truth[0].T_WI.p() + 0.6 * truth[2].T_WI.p(), 1e-12));
}

TEST_F(CliEstimate, RepeatsEveryByteButItsTimings) {
  ASSERT_EQ(Estimate({}).exit_code, 0);
  std::map<std::string, std::string> first;
  for (const auto& entry : fs::directory_iterator(Result("")))
    first[entry.path().filename().string()] = ReadFile(entry.path());
  EXPECT_EQ(first.size(), 9U);
  ASSERT_EQ(Estimate({}).exit_code, 0);
  first.erase("timings.json");
  for (const auto& [name, content] : first) EXPECT_EQ(ReadFile(Result(name)), content) << name;
}

// The pressure port of this rig is where that of the recording's is, so only the manifest tells.
TEST_F(CliEstimate, BelievesTheRigThatItIsGiven) {
  ASSERT_EQ(Estimate({"--rig", "svin2_v3"}).exit_code, 0);
  EXPECT_THAT(std::string(Json("manifest.json")["rig"]), HasSubstr("name: \"svin2_v3\""));
  ASSERT_EQ(Estimate({}).exit_code, 0);
  EXPECT_THAT(std::string(Json("manifest.json")["rig"]), HasSubstr("name: \"small\""));
}

// Ours alone have arrivals.csv, rig.yaml, sonar and pressure; none of them is required.
TEST_F(CliEstimate, ReadsRecordingsOfOthers) {
  for (const char* name :
       {"arrivals.csv", "rig.yaml", "body.yaml", "sonar0", "sonar0_groundtruth", "pressure0"})
    fs::remove_all(folder_.path() / "glide" / "mav0" / name);
  const Outcome outcome = Estimate({});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("27 measurements"));  // 21 samples and 6 frames.
  EXPECT_EQ(dataset::ReadTum(Result("odometry.tum")).size(), 21U);
}

TEST_F(CliEstimate, WarnsOfFramesWithoutAPartner) {
  fs::remove(folder_.path() / "glide" / "mav0" / "arrivals.csv");
  const fs::path table = folder_.path() / "glide" / "mav0" / "cam1" / "data.csv";
  WriteFileAtomically(table, ReadFile(table).substr(0, 55));  // The header and one frame.
  const Outcome outcome = Estimate({});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("drydock: warning: "));
  EXPECT_THAT(outcome.err, HasSubstr("5 images without a partner"));
}

TEST_F(CliEstimate, NeedsImuSamples) {
  fs::remove(folder_.path() / "glide" / "mav0" / "arrivals.csv");
  WriteFileAtomically(folder_.path() / "glide" / "mav0" / "imu0" / "data.csv", "#timestamp [ns]\n");
  const Outcome outcome = Estimate({});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("imu0/data.csv: no samples"));
  EXPECT_FALSE(fs::exists(Result("")));
}

TEST_F(CliEstimate, ReplacesResultsAndNothingElse) {
  ASSERT_EQ(Estimate({}).exit_code, 0);
  WriteFileAtomically(Result("old"), "");
  ASSERT_EQ(Estimate({}).exit_code, 0);
  EXPECT_FALSE(fs::exists(Result("old")));
  fs::remove(Result("manifest.json"));
  WriteFileAtomically(Result("chapter1.txt"), "Introduction");
  const Outcome outcome = Estimate({});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("result: holds other things (no manifest.json)"));
  EXPECT_TRUE(fs::exists(Result("chapter1.txt")));
}

}  // namespace
}  // namespace drydock::testing
