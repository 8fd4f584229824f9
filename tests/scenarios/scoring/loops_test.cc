#include "scenarios/scoring/loops.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenarios/scoring/support.h"

namespace drydock::score {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// A straight line at 0.5 m/s for 100 s, a pose each 0.1 s.
Trajectory Line() {
  return MakeTrajectory(1001, 0.1, [](double t) { return Eigen::Vector3d(0.5 * t, 0.0, 0.0); });
}

/// 20 m in 40 s, and at once again along the same line, this time `beside` metres beside it and
/// turned by `yaw`.
Trajectory Twice(double beside, double yaw) {
  Trajectory truth;
  for (int i = 0; i < 800; ++i) {
    const bool again = i >= 400;
    truth.push_back(
        {Time::FromSeconds(0.1 * i), Pose(FromYawPitchRoll(again ? yaw : 0.0, 0.0, 0.0),
                                          {0.05 * (i % 400), again ? beside : 0.0, 0.0})});
  }
  return truth;
}

/// The loop that is true between two instants, off by `miss` [m] sideways and `turn` [rad].
Loop LoopBetween(const Trajectory& truth, double now, double then, double miss = 0.0,
                 double turn = 0.0) {
  const Time t_now = Time::FromSeconds(now);
  const Time t_then = Time::FromSeconds(then);
  const Pose exact = Interpolate(truth, t_then)->Inverse() * *Interpolate(truth, t_now);
  return {t_now, t_then,
          Pose(ExpSO3({0.0, 0.0, turn}) * exact.q(), exact.p() + Eigen::Vector3d(0, miss, 0))};
}

TEST(LoopTruth, AllowsAQuarterMetreAndATwentiethOfTheWay) {
  const Trajectory truth = Line();
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.05, 40.05, 0.24)), true);
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.05, 40.05, 0.26)), false);
  // Between 30 and 40 s lie 5 m: 0.5 m in all.
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.0, 30.0, 0.49)), true);
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.0, 30.0, 0.51)), false);
}

TEST(LoopTruth, AllowsFiveDegrees) {
  const Trajectory truth = Line();
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.0, 30.0, 0.0, 4.9 * kRadians)), true);
  EXPECT_EQ(IsTrue(truth, LoopBetween(truth, 40.0, 30.0, 0.0, -5.1 * kRadians)), false);
}

TEST(LoopTruth, IsThatOfTheBodyNowInTheBodyThen) {
  const Trajectory truth = Line();
  Loop loop = LoopBetween(truth, 40.0, 30.0);
  EXPECT_NEAR(loop.T_then_now.p().x(), 5.0, 1e-9);
  loop.T_then_now = loop.T_then_now.Inverse();
  EXPECT_EQ(IsTrue(truth, loop), false);
}

TEST(LoopTruth, IsUnknownOutsideTheTruthAndFalseForNoNumber) {
  const Trajectory truth = Line();
  Loop loop = LoopBetween(truth, 40.0, 30.0);
  loop.t_now = Time::FromSeconds(100.5);
  EXPECT_FALSE(IsTrue(truth, loop));
  loop = LoopBetween(truth, 40.0, 30.0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(IsTrue(truth, loop), false);
}

TEST(LoopScore, PrecisionIsTheShareOfTrueOnes) {
  const Trajectory truth = Line();
  Loop unknown = LoopBetween(truth, 40.0, 30.0);
  unknown.t_then = Time::FromSeconds(-1.0);
  const LoopScore score =
      ScoreLoops(truth, {LoopBetween(truth, 40.0, 30.0), LoopBetween(truth, 50.0, 30.0, 3.0),
                         unknown, LoopBetween(truth, 60.0, 30.0), LoopBetween(truth, 70.0, 30.0)});
  EXPECT_EQ(score.judged, 4U);
  EXPECT_EQ(score.PrecisionPercent(), 75.0);
  EXPECT_EQ(ScoreLoops(truth, {}).PrecisionPercent(), 100.0);
  EXPECT_FALSE(score.RecallPercent()) << "nothing is seen twice";
}

TEST(LoopScore, RevisitsAreNearAndTurnedLittle) {
  // 20 m have a place each 0.5 m.
  EXPECT_EQ(ScoreLoops(Twice(1.4, 0.0), {}).revisits, 40U);
  EXPECT_EQ(ScoreLoops(Twice(1.6, 0.0), {}).revisits, 0U);
  EXPECT_EQ(ScoreLoops(Twice(0.0, 29.0 * kRadians), {}).revisits, 40U);
  EXPECT_EQ(ScoreLoops(Twice(0.0, 31.0 * kRadians), {}).revisits, 0U);
}

TEST(LoopScore, WhatWasJustPassedIsNoRevisit) {
  // Round a circle in 15 s: too soon; in 21 s: not. And 50 s at one place: too short a way.
  const auto around = [](double period) {
    return MakeTrajectory(600, 0.1, [period](double t) {
      return Eigen::Vector3d(2.0 * std::sin(2.0 * std::numbers::pi * t / period),
                             2.0 * std::cos(2.0 * std::numbers::pi * t / period), 0.0);
    });
  };
  Trajectory circle = around(15.0);
  circle.resize(190);
  EXPECT_EQ(ScoreLoops(circle, {}).revisits, 0U);
  EXPECT_GT(ScoreLoops(around(21.0), {}).revisits, 0U);
  const Trajectory hover = MakeTrajectory(600, 0.1, [](double t) {
    return Eigen::Vector3d(t < 50.0 ? 0.0 : 0.4 * (t - 50.0), 0.0, 0.0);
  });
  EXPECT_EQ(ScoreLoops(hover, {}).revisits, 0U);
}

TEST(LoopScore, ARevisitIsFoundByATrueLoopNearby) {
  const Trajectory truth = Twice(0.5, 0.0);
  // The places of the second way are passed each second from 40 s on.
  const LoopScore score = ScoreLoops(truth, {LoopBetween(truth, 45.5, 5.0),        // 45 and 46 s
                                             LoopBetween(truth, 60.0, 20.0),       // 59 to 61 s
                                             LoopBetween(truth, 70.0, 30.0, 2.0),  // False.
                                             LoopBetween(truth, 70.0, 55.0)});     // Too short.
  EXPECT_EQ(score.revisits, 40U);
  EXPECT_EQ(score.found, 5U);
  EXPECT_EQ(score.RecallPercent(), 12.5);
}

}  // namespace
}  // namespace drydock::score
