// Golden values: evo 1.36, see tests/data/oracle/README.md.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scenarios/dataset/tum.h"
#include "scenarios/scoring/trajectory_score.h"
#include "sensors_models/base/files.h"

namespace drydock::score {
namespace {

constexpr double kTolerance = 1e-9;
constexpr double kDegrees = 180.0 / std::numbers::pi;

class Oracle : public testing::TestWithParam<std::string> {
 protected:
  Oracle()
      : folder_(ORACLE_DIR),
        truth_(dataset::ReadTum(folder_ / "truth.tum")),
        estimate_(dataset::ReadTum(folder_ / (GetParam() + "_estimate.tum"))),
        golden_(nlohmann::json::parse(ReadFile(folder_ / (GetParam() + ".json")))),
        pairs_(Associate(truth_, estimate_, {}).pairs) {}

  void ExpectGolden(const std::string& name, std::vector<double> errors, double unit = 1.0) {
    ASSERT_TRUE(golden_.contains(name)) << name;
    for (double& error : errors) error *= unit;
    const auto actual = Summarize(errors);
    ASSERT_TRUE(actual.has_value());
    const auto& golden = golden_[name];
    EXPECT_EQ(golden.size(), 7U);
    EXPECT_NEAR(actual->rmse, golden["rmse"], kTolerance) << name;
    EXPECT_NEAR(actual->mean, golden["mean"], kTolerance) << name;
    EXPECT_NEAR(actual->median, golden["median"], kTolerance) << name;
    EXPECT_NEAR(actual->standard_deviation, golden["std"], kTolerance) << name;
    EXPECT_NEAR(actual->min, golden["min"], kTolerance) << name;
    EXPECT_NEAR(actual->max, golden["max"], kTolerance) << name;
    EXPECT_NEAR(actual->sse, golden["sse"], kTolerance * std::max(1.0, actual->sse)) << name;
    golden_.erase(name);
  }

  PoseErrors Ape(Alignment alignment) { return AbsoluteErrors(pairs_, *Align(pairs_, alignment)); }

  std::filesystem::path folder_;
  Trajectory truth_;
  Trajectory estimate_;
  nlohmann::json golden_;
  std::vector<PosePair> pairs_;
};

TEST_P(Oracle, EveryFigureAgrees) {
  ExpectGolden("ape_trans_none", Ape(Alignment::kNone).translation);
  ExpectGolden("ape_trans_se3", Ape(Alignment::kSe3).translation);
  ExpectGolden("ape_trans_sim3", Ape(Alignment::kSim3).translation);
  ExpectGolden("ape_trans_origin", Ape(Alignment::kOrigin).translation);
  ExpectGolden("ape_rot_deg_se3", Ape(Alignment::kSe3).rotation, kDegrees);

  StepOptions frames{.step = 10.0, .unit = StepOptions::Unit::kFrames};
  ExpectGolden("rpe_trans_10frames_all", RelativeErrors(pairs_, frames).translation);
  ExpectGolden("rpe_rot_deg_10frames_all", RelativeErrors(pairs_, frames).rotation, kDegrees);
  frames.all_pairs = false;
  ExpectGolden("rpe_trans_10frames", RelativeErrors(pairs_, frames).translation);
  ExpectGolden("rpe_trans_5m_all", RelativeErrors(pairs_, StepOptions{}).translation);
  EXPECT_TRUE(golden_.empty()) << "not checked: " << golden_.dump();
}

TEST_P(Oracle, ScoreUsesTheSameFigures) {
  const double ate = golden_["ape_trans_se3"]["rmse"];
  const double rpe = golden_["rpe_trans_5m_all"]["mean"];
  const TrajectoryScore score = ScoreTrajectories(truth_, estimate_, Alignment::kSe3);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, ate, kTolerance);
  EXPECT_NEAR(*score.metrics.rpe_5m_percent, 100.0 * rpe / 5.0, 1e-7);
}

// Truth is at 100 Hz, the estimate between its stamps: interpolation removes what the body moved in
// up to 5 ms, far below the error itself.
TEST_P(Oracle, InterpolatedTruthGivesNearlyTheSame) {
  const TrajectoryScore score = ScoreTrajectories(truth_, estimate_, Alignment::kSe3,
                                                  {.mode = AssociationMode::kInterpolate});
  EXPECT_EQ(score.association.pairs.size(), pairs_.size());
  EXPECT_NEAR(*score.metrics.ate_rmse_m, golden_["ape_trans_se3"]["rmse"], 1e-3);
}

INSTANTIATE_TEST_SUITE_P(AB, Oracle, testing::Values("a", "b"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace drydock::score
