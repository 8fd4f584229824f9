#include "estimator/svin2/odometry/swimming_habit.h"

#include <cmath>

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

NavState Swimming(double t, double yaw, const Vector3d& v_I) {
  NavState state;
  state.t = Time::FromSeconds(t);
  state.T_WI = Pose(FromYawPitchRoll(yaw, 0.0, 0.0), {1, 2, 3});
  state.v_W = state.T_WI.q() * v_I;
  return state;
}

TEST(SwimmingHabit, IsTheMeanVelocityInTheBody) {
  SwimmingHabit habit({.memory_s = 2.0});
  EXPECT_EQ(habit.v_I().norm(), 0.0) << "nothing was learnt";
  habit.Learn(Swimming(0.0, 0.3, {0.4, 0.1, 0.0}));
  EXPECT_LT((habit.v_I() - Vector3d(0.4, 0.1, 0.0)).norm(), 1e-12) << "there is no other";
  habit.Learn(Swimming(1.0, 2.0, {0.4, 0.1, 0.0}));
  EXPECT_LT((habit.v_I() - Vector3d(0.4, 0.1, 0.0)).norm(), 1e-12) << "turning changes nothing";
  habit.Learn(Swimming(3.0, 1.0, {0.0, 0.0, 0.0}));
  EXPECT_LT((habit.v_I() - std::exp(-1.0) * Vector3d(0.4, 0.1, 0.0)).norm(), 1e-12);
}

TEST(SwimmingHabit, SaysTheSameHoweverOftenItIsAsked) {
  const SwimmingHabit habit({.sigma = 0.3, .correlation_s = 3.0});
  const double at_10_hz = *habit.SigmaEach(Duration::FromSeconds(0.1));
  const double at_20_hz = *habit.SigmaEach(Duration::FromSeconds(0.05));
  EXPECT_NEAR(at_10_hz, 0.3 * std::sqrt(60.0), 1e-9);
  EXPECT_NEAR(10.0 / (at_10_hz * at_10_hz), 20.0 / (at_20_hz * at_20_hz), 1e-9);
  EXPECT_NEAR(*habit.SigmaEach(Duration::FromSeconds(60.0)), 0.3, 1e-9) << "one alone: itself";
}

TEST(SwimmingHabit, MayBeSwitchedOff) {
  EXPECT_FALSE(SwimmingHabit({.sigma = 0.0}).SigmaEach(Duration::FromSeconds(0.1)));
}

}  // namespace
}  // namespace drydock::svin2
