#include "scenarios/scoring/trajectory_score.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scoring/json.h"
#include "sensors_models/base/check.h"
#include "tests/scenarios/scoring/support.h"
#include "tests/support/input_error.h"

namespace drydock::score {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::HasSubstr;

TEST(ScoreTrajectories, PerfectEstimate) {
  const TrajectoryScore score = ScoreTrajectories(Helix(), Helix(), Alignment::kSe3);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.0, 1e-13);
  EXPECT_NEAR(*score.metrics.scale_error_percent, 0.0, 1e-12);
  EXPECT_NEAR(*score.metrics.final_drift_percent, 0.0, 1e-12);
  EXPECT_NEAR(*score.metrics.yaw_error_deg, 0.0, 1e-12);
  EXPECT_NEAR(*score.metrics.z_rmse_m, 0.0, 1e-13);
  EXPECT_NEAR(*score.metrics.rpe_5m_percent, 0.0, 1e-12);
  EXPECT_EQ(*score.metrics.continuity_percent, 100.0);
  EXPECT_EQ(*score.metrics.init_time_s, 0.0);
  EXPECT_DOUBLE_EQ(score.duration_s, 30.0);
  EXPECT_DOUBLE_EQ(score.path_length_m, PathLength(Helix()));
}

TEST(ScoreTrajectories, PureScaleIsAScaleErrorAndNothingElse) {
  const Trajectory estimate = Moved(Helix(), Pose(), 1.1);
  const TrajectoryScore score = ScoreTrajectories(Helix(), estimate, Alignment::kSim3);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.0, 1e-13);
  EXPECT_NEAR(*score.metrics.scale_error_percent, 10.0, 1e-10);
  EXPECT_NEAR(*score.metrics.yaw_error_deg, 0.0, 1e-10);
}

TEST(ScoreTrajectories, PureYawOrTranslationIsNoErrorAfterYawAlignment) {
  const Trajectory estimate =
      Moved(Helix(), Pose(FromYawPitchRoll(2.0, 0.0, 0.0), {10.0, -20.0, 5.0}));
  const TrajectoryScore score = ScoreTrajectories(Helix(), estimate, Alignment::kYaw);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.0, 1e-12);
  EXPECT_NEAR(*score.metrics.yaw_error_deg, 0.0, 1e-10);
  EXPECT_NEAR(*score.metrics.final_drift_percent, 0.0, 1e-10);
  const TrajectoryScore raw = ScoreTrajectories(Helix(), estimate, Alignment::kNone);
  EXPECT_GT(*raw.metrics.ate_rmse_m, 20.0);
}

// An estimate that stays behind by 0.1 m a metre on a straight line ends 10 % short.
TEST(ScoreTrajectories, FinalDriftByHand) {
  const auto along = [](double speed) {
    return MakeTrajectory(101, 0.1,
                          [speed](double t) { return Eigen::Vector3d(speed * t, 0.0, 0.0); });
  };
  const TrajectoryScore score = ScoreTrajectories(along(1.0), along(0.9), Alignment::kYaw);
  EXPECT_NEAR(*score.metrics.final_drift_percent, 10.0, 1e-10);
  // 5 m along the estimate are 5.55… m in truth.
  EXPECT_NEAR(*score.metrics.rpe_5m_percent, 100.0 * (5.04 / 0.9 - 5.04) / 5.0, 0.2);
  // On a straight line neither scale nor SE(3) is determined.
  EXPECT_FALSE(score.metrics.scale_error_percent.has_value());
}

TEST(ScoreTrajectories, DriftCountsFromTheFirstPoseOfTheEstimate) {
  Trajectory truth = Helix();
  Trajectory estimate(truth.begin() + 100, truth.end());
  // The last pose is 1 m off; the path since the first pose of the estimate is two thirds.
  estimate.back().T_WI =
      Pose(estimate.back().T_WI.q(), estimate.back().T_WI.p() + Eigen::Vector3d(0.0, 0.0, 1.0));
  const TrajectoryScore score = ScoreTrajectories(truth, estimate, Alignment::kSe3);
  const double path = PathLength(Trajectory(truth.begin() + 100, truth.end()));
  EXPECT_NEAR(*score.metrics.final_drift_percent, 100.0 / path, 1e-10);
  EXPECT_NEAR(*score.metrics.init_time_s, 10.0, 1e-12);
}

TEST(ScoreTrajectories, HeadingErrorIsYawErrorAlone) {
  Trajectory estimate = Helix();
  for (StampedPose& pose : estimate) {
    pose.T_WI = Pose(FromYawPitchRoll(0.1, 0.0, 0.0) * pose.T_WI.q(), pose.T_WI.p());
  }
  const TrajectoryScore score = ScoreTrajectories(Helix(), estimate, Alignment::kYaw);
  EXPECT_NEAR(*score.metrics.yaw_error_deg, 5.729577951308232, 1e-10);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.0, 1e-12);
}

TEST(ScoreTrajectories, VerticalErrorIsSeenByZAlone) {
  Trajectory estimate = Helix();
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double z = i % 2 == 0 ? 0.2 : -0.2;
    estimate[i].T_WI =
        Pose(estimate[i].T_WI.q(), estimate[i].T_WI.p() + Eigen::Vector3d(0.0, 0.0, z));
  }
  const TrajectoryScore score = ScoreTrajectories(Helix(), estimate, Alignment::kYaw);
  EXPECT_NEAR(*score.metrics.z_rmse_m, 0.2, 1e-5);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.2, 1e-5);
}

TEST(ScoreTrajectories, ShortPathsHaveNoStepsOfFiveMetres) {
  const Trajectory truth =
      MakeTrajectory(50, 0.1, [](double t) { return Eigen::Vector3d(0.1 * t, 0.05 * t * t, 0.0); });
  const TrajectoryScore score = ScoreTrajectories(truth, truth, Alignment::kSe3);
  EXPECT_FALSE(score.metrics.rpe_5m_percent.has_value());
  EXPECT_FALSE(score.rpe_translation.has_value());
  EXPECT_THAT(ToJson(score), HasSubstr("\"rpe_5m_percent\": null"));
}

TEST(ScoreTrajectories, ABodyThatRestsHasNoShareOfItsPath) {
  const Trajectory truth =
      MakeTrajectory(50, 0.1, [](double) { return Eigen::Vector3d(1.0, 2.0, 3.0); });
  const TrajectoryScore score = ScoreTrajectories(truth, truth, Alignment::kOrigin);
  EXPECT_NEAR(*score.metrics.ate_rmse_m, 0.0, 1e-15);
  EXPECT_FALSE(score.metrics.ate_percent.has_value());
  EXPECT_FALSE(score.metrics.final_drift_percent.has_value());
  EXPECT_THAT(ToJson(score), ::testing::Not(HasSubstr("nan")));
}

TEST(ScoreTrajectories, SaysWhyItCannot) {
  const Trajectory truth = Helix();
  EXPECT_THAT(InputErrorOf([&] { ScoreTrajectories(truth, {}, Alignment::kSe3); }),
              HasSubstr("estimated trajectory is empty"));
  EXPECT_THAT(InputErrorOf([&] { ScoreTrajectories({}, truth, Alignment::kSe3); }),
              HasSubstr("true trajectory is empty"));
  Trajectory later = truth;
  for (StampedPose& pose : later) pose.t.ns += 100 * kNanosecondsPerSecond;
  EXPECT_THAT(InputErrorOf([&] { ScoreTrajectories(truth, later, Alignment::kSe3); }),
              AllOf(HasSubstr("clocks"), HasSubstr("100.0"), HasSubstr("within 0.01 s")));
  EXPECT_THAT(InputErrorOf([&] {
                ScoreTrajectories(truth, {truth[0], truth[1]}, Alignment::kSe3);
              }),
              AllOf(HasSubstr("2 associated poses"), HasSubstr("'se3'")));
  EXPECT_FALSE(TryScoreTrajectories(truth, later, Alignment::kSe3).has_value());
}

TEST(Continuity, ByHand) {
  const auto at = [](std::initializer_list<double> seconds) {
    Trajectory trajectory;
    for (const double t : seconds) trajectory.push_back({Time::FromSeconds(t), Pose()});
    return trajectory;
  };
  const Trajectory truth = at({0, 5, 10});
  constexpr Duration kSecond{kNanosecondsPerSecond};
  EXPECT_EQ(Continuity(truth, {}, kSecond), 0.0);
  EXPECT_EQ(Continuity({}, truth, kSecond), 0.0);
  EXPECT_EQ(Continuity(truth, at({11, 12}), kSecond), 0.0);
  EXPECT_DOUBLE_EQ(Continuity(truth, at({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), kSecond), 1.0);
  // A gap of 4 s in 10 s.
  EXPECT_DOUBLE_EQ(Continuity(truth, at({0, 1, 2, 3, 7, 8, 9, 10}), kSecond), 0.6);
  // Lost at 5 s for good.
  EXPECT_DOUBLE_EQ(Continuity(truth, at({0, 1, 2, 3, 4, 5}), kSecond), 0.5);
  // The wait for the first pose counts apart; poses outside the dive do not count.
  EXPECT_DOUBLE_EQ(Continuity(truth, at({-1, 6, 7, 8, 9, 10, 11}), kSecond), 1.0);
  EXPECT_DOUBLE_EQ(Continuity(truth, at({10}), kSecond), 1.0);
}

}  // namespace
}  // namespace drydock::score
