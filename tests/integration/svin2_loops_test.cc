// SVIn2 on a simulated dive that comes back to where it began: loops, and what they mend.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/registry/registry.h"
#include "tests/integration/dark_trial.h"
#include "tests/integration/recorded_dive.h"

namespace drydock {
namespace {

using testing::RecordedDive;

class Svin2Loops : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    // It is back in sight of its first place after 16.5 s.
    dive_ = std::make_unique<RecordedDive>(
        testing::Record("bus_return.yaml", {"seed=5", "duration_s=19.5"}));
  }
  static void TearDownTestSuite() { dive_.reset(); }

  /// Started by its own initialisation.
  static std::unique_ptr<Estimator> Run(const std::string& name) {
    auto estimator = FindEstimator(name).make(dive_->rig, NoOptions());
    estimator->Start(std::nullopt);
    for (const Measurement& m : dive_->measurements) estimator->Add(m);
    estimator->Finish();
    return estimator;
  }

  static inline std::unique_ptr<RecordedDive> dive_;
};

TEST_F(Svin2Loops, AreTrueAndLeaveOdometryAsItIs) {
  const auto svin2 = Run("svin2"), without = Run("svin2-noloop");
  const score::LoopScore score = testing::ScoreLoops(*dive_, *svin2);
  std::printf("%zu loops, %zu true; %zu of %zu revisits found\n", score.judged, score.true_loops,
              score.found, score.revisits);
  EXPECT_GE(score.true_loops, 3U);
  EXPECT_EQ(score.true_loops, score.judged);

  ASSERT_EQ(svin2->Odometry().size(), without->Odometry().size());
  for (std::size_t k = 0; k < svin2->Odometry().size(); ++k) {
    ASSERT_EQ(svin2->Odometry()[k].T_WI.p(), without->Odometry()[k].T_WI.p()) << k;
    ASSERT_EQ(svin2->Odometry()[k].T_WI.q().coeffs(), without->Odometry()[k].T_WI.q().coeffs());
  }
  EXPECT_TRUE(without->Loops().empty());
  EXPECT_GT(svin2->Map().landmarks.size(), 100U);
  EXPECT_GT(svin2->Map().sonar.size(), 100U);
}

TEST_F(Svin2Loops, RelocaliseAfterTenSecondsOfBlackness) {
  const testing::DarkTrial trial =
      testing::RunInTheDark(*dive_, Time::FromSeconds(6.5), Time::FromSeconds(16.5));
  std::printf("%s\n", testing::Line(trial).c_str());
  EXPECT_EQ(trial.maps, 1);
  EXPECT_EQ(trial.true_loops, trial.loops);
  ASSERT_TRUE(trial.recognised_s.has_value() && trial.corrected_s.has_value());
  EXPECT_GE(*trial.recognised_s, 0.0);
  EXPECT_LE(*trial.corrected_s, 3.0);
  EXPECT_LE(trial.ate_percent, 0.3);
  EXPECT_LT(trial.ate_percent, trial.ate_odometry_percent);
  EXPECT_LT(trial.live_error_m, 0.1);
}

}  // namespace
}  // namespace drydock
