#include "sim/motion/spline_motion.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"
#include "tests/support/numeric.h"

namespace drydock::sim {
namespace {

using drydock::testing::InputErrorOf;

using testing::NumericDerivative;

MotionConfig Square() {
  MotionConfig config;
  config.speed_m_s = 0.45;
  config.sway = {0.02, 0.03};
  for (const auto& [x, y] : {std::pair(0.0, 0.0),
                             {2.0, 0.1},
                             {4.0, 0.0},
                             {5.0, 1.0},
                             {5.1, 3.0},
                             {4.0, 4.0},
                             {2.0, 4.1},
                             {0.0, 4.0}}) {
    Waypoint waypoint;
    waypoint.position = {x, y, 0.1 * x};
    config.waypoints.push_back(waypoint);
  }
  config.waypoints[3].look_at = Eigen::Vector3d(2.0, 2.0, 0.0);
  config.waypoints[5].pitch_rad = 0.4;
  return config;
}

Time At(double seconds) { return Time::FromSeconds(seconds); }

TEST(SplineMotion, VelocityAndAccelerationMatchNumeric) {
  const SplineMotion motion(Square(), 1);
  for (double t = 0.5; t < motion.End().Seconds() - 0.5; t += 0.61) {
    const MotionState state = motion.At(At(t));
    const Eigen::Vector3d v =
        NumericDerivative([&](double x) { return motion.At(At(x)).T_WI.p(); }, t);
    const Eigen::Vector3d a = NumericDerivative([&](double x) { return motion.At(At(x)).v_W; }, t);
    EXPECT_LT((state.v_W - v).norm(), 1e-6) << t;
    EXPECT_LT((state.a_W - a).norm(), 1e-5) << t;
  }
}

TEST(SplineMotion, AngularRateMatchesNumeric) {
  const SplineMotion motion(Square(), 1);
  constexpr double kStep = 1e-4;
  for (double t = 0.5; t < motion.End().Seconds() - 0.5; t += 0.61) {
    const Eigen::Quaterniond before = motion.At(At(t - kStep)).T_WI.q();
    const Eigen::Quaterniond after = motion.At(At(t + kStep)).T_WI.q();
    const Eigen::Vector3d numeric = LogSO3(before.conjugate() * after) / (2.0 * kStep);
    EXPECT_LT((motion.At(At(t)).w_I - numeric).norm(), 1e-6) << t;
  }
}

TEST(SplineMotion, RestsBeforeItSwimsAsItWould) {
  const SplineMotion at_once(Square(), 1);
  MotionConfig config = Square();
  config.rest_s = 3.0;
  const SplineMotion rested(config, 1);
  for (const double t : {0.0, 1.0, 3.0}) {
    EXPECT_EQ(rested.At(At(t)).T_WI.p(), at_once.At(Time{}).T_WI.p()) << t;
    EXPECT_EQ(rested.At(At(t)).v_W.norm() + rested.At(At(t)).w_I.norm(), 0.0) << t;
  }
  EXPECT_EQ(rested.End(), At(at_once.End().Seconds() + 3.0));
  EXPECT_LT((rested.At(At(9.5)).T_WI.p() - at_once.At(At(6.5)).T_WI.p()).norm(), 1e-12);
  EXPECT_EQ(rested.NearestWaypoint(At(2.0)), 0U);
}

TEST(SplineMotion, KeepsItsSpeedBetweenRestAndRest) {
  MotionConfig config = Square();
  config.sway = {};
  const SplineMotion motion(config, 1);
  EXPECT_LT(motion.At(Time{}).v_W.norm(), 1e-12);
  EXPECT_LT(motion.At(motion.End()).v_W.norm(), 1e-12);
  const double end = motion.End().Seconds();
  for (double t = 0.3 * end; t < 0.7 * end; t += 0.1)
    EXPECT_NEAR(motion.At(At(t)).v_W.norm(), 0.45, 0.05) << t;
}

TEST(SplineMotion, LooksWhereItIsTold) {
  MotionConfig config = Square();
  config.sway = {};
  const SplineMotion motion(config, 1);
  // At the third corner the rig looks at (2, 2, 0); find the instant when it is there.
  double nearest = 1e9;
  MotionState there;
  for (double t = 0.0; t < motion.End().Seconds(); t += 0.002) {
    const MotionState state = motion.At(At(t));
    const double distance = (state.T_WI.p() - config.waypoints[3].position).norm();
    if (distance < nearest) {
      nearest = distance;
      there = state;
    }
  }
  const Eigen::Vector3d forward = there.T_WI.q() * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d wanted = (Eigen::Vector3d(2.0, 2.0, 0.0) - there.T_WI.p()).normalized();
  EXPECT_LT((forward - wanted).norm(), 0.01);
}

TEST(SplineMotion, KnowsItsNearestWaypoint) {
  MotionConfig config;
  for (const double x : {0.0, 2.0, 4.0, 6.0}) {
    config.waypoints.emplace_back();
    config.waypoints.back().position = {x, 0.0, 0.0};
  }
  const SplineMotion motion(config, 1);
  for (double t = 0.0; t < motion.End().Seconds(); t += 0.1) {
    const double x = motion.At(At(t)).T_WI.p().x();
    const double fraction = x / 2.0 - std::floor(x / 2.0);
    // Near in time is near in space, but for the acceleration at both ends.
    if (fraction > 0.2 && fraction < 0.8) continue;
    EXPECT_EQ(motion.NearestWaypoint(At(t)), static_cast<std::size_t>(std::lround(x / 2.0))) << x;
  }
  EXPECT_EQ(motion.NearestWaypoint(motion.End()), 3U);
}

/// Along x, with steps of these lengths.
MotionConfig Line(const std::vector<double>& steps) {
  MotionConfig config;
  config.waypoints.resize(1 + steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    config.waypoints[i + 1].position = config.waypoints[i].position;
    config.waypoints[i + 1].position.x() += steps[i];
    config.waypoints[i + 1].place = fmt::format("f.yaml:{}: motion.waypoints.{}", 10 + i, i + 1);
  }
  return config;
}

// With neighbours that are fifty times as long, the curve grows by more in each round: to 1e26
// times its polygon before the times run out of digits.
TEST(SplineMotion, RefusesACurveThatSwingsOut) {
  EXPECT_NO_THROW(SplineMotion(Line({1.0, 10.0, 1.0, 10.0}), 1));
  const std::string message = InputErrorOf([] {
    const SplineMotion motion(Line({1.0, 50.0, 1.0, 50.0}), 1);
  });
  EXPECT_EQ(message.find("f.yaml:13: motion.waypoints.4: "), 0U) << message;
  EXPECT_NE(message.find("at most 2 times the 102 m"), std::string::npos) << message;
}

// The way round is far longer than the polygon, but the curve settles.
TEST(SplineMotion, SwimsATightUTurn) {
  MotionConfig config = Line({100.0, 1.0, 1.0});
  config.waypoints[2].position = {100.0, 1.0, 0.0};
  config.waypoints[3].position = {0.0, 1.0, 0.0};
  EXPECT_NO_THROW(SplineMotion(config, 1));
}

TEST(SplineMotion, YawIsUnwrapped) {
  MotionConfig config;
  for (int i = 0; i <= 16; ++i) {  // Twice around: yaw passes pi four times.
    const double angle = std::numbers::pi / 4.0 * i;
    Waypoint waypoint;
    waypoint.position = {3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.05 * i};
    config.waypoints.push_back(waypoint);
  }
  const SplineMotion motion(config, 1);
  for (double t = 0.0; t < motion.End().Seconds(); t += 0.1)
    EXPECT_LT(motion.At(At(t)).w_I.norm(), 0.5) << t;
}

}  // namespace
}  // namespace drydock::sim
