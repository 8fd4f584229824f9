// SVIn2 on a simulated dive that comes back to where it began: loops, and what they mend.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/registry/registry.h"
#include "scenarios/scoring/loops.h"
#include "scenarios/scoring/scorecard.h"
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

  /// Started by its own initialisation; black from `black_from` to `black_to`.
  static std::unique_ptr<Estimator> Run(const std::string& name, Time black_from = {},
                                        Time black_to = {}) {
    auto estimator = FindEstimator(name).make(dive_->rig, NoOptions());
    estimator->Start(std::nullopt);
    for (const Measurement& m : dive_->measurements)
      estimator->Add(m.t >= black_from && m.t < black_to ? testing::Blackened(m) : m);
    estimator->Finish();
    return estimator;
  }

  static score::LoopScore ScoreOf(const Estimator& estimator) {
    std::vector<score::Loop> loops;
    for (const LoopClosure& loop : estimator.Loops())
      loops.push_back({loop.t_now, loop.t_then, loop.T_then_now});
    return score::ScoreLoops(dive_->truth, loops);
  }

  /// Position error (RMSE) of the poses outside [from, to), aligned, as a share of the path [%].
  static double AtePercentOutside(const Trajectory& trajectory, Time from, Time to) {
    Trajectory kept;
    for (const StampedPose& pose : trajectory)
      if (pose.t < from || pose.t >= to) kept.push_back(pose);
    return score::Score({}, dive_->truth, kept, kept, {}).metrics.ate_percent.value();
  }

  static inline std::unique_ptr<RecordedDive> dive_;
};

TEST_F(Svin2Loops, AreTrueAndLeaveOdometryAsItIs) {
  const auto svin2 = Run("svin2"), without = Run("svin2-noloop");
  const score::LoopScore score = ScoreOf(*svin2);
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
  const Time dark = Time::FromSeconds(6.5), light = Time::FromSeconds(16.5);
  const auto svin2 = Run("svin2", dark, light);
  ASSERT_FALSE(svin2->Loops().empty());
  const Time first = svin2->Loops().front().t_now;
  const double corrected = AtePercentOutside(svin2->Corrected(), dark, first);
  const double odometry = AtePercentOutside(svin2->Odometry(), dark, first);
  std::printf("relocalised %.2f s after the light came back; ATE %.3f %%, of odometry %.3f %%\n",
              (first - light).Seconds(), corrected, odometry);
  EXPECT_GE(first, light);
  EXPECT_LE((first - light).Seconds(), 3.0);
  EXPECT_LE(corrected, 0.3);
  EXPECT_LT(corrected, odometry);
  EXPECT_EQ(ScoreOf(*svin2).true_loops, ScoreOf(*svin2).judged);
}

}  // namespace
}  // namespace drydock
