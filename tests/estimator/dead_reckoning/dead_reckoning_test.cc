#include "estimator/dead_reckoning/dead_reckoning.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

const ImuSample kRest{{0, 0, 0}, {0, 0, 9.81}};

Measurement At(double seconds, const Reading& reading) {
  const Time t = Time::FromSeconds(seconds);
  return {t, t, reading};
}

TEST(DeadReckoning, HasToBeToldWhereItStarts) {
  DeadReckoning estimator(Rig{});
  EXPECT_THROW(estimator.Start(std::nullopt), InputError);
  EXPECT_FALSE(estimator.Latest());
}

TEST(DeadReckoning, StaysWhereItIs) {
  DeadReckoning estimator(Rig{});
  NavState known;
  known.T_WI = Pose(Eigen::Quaterniond::Identity(), {1, 2, 3});
  estimator.Start(known);
  for (int k = 0; k <= 500; ++k) {
    estimator.Add(At(0.01 * k, kRest));
    if (k % 100 == 0) estimator.Add(At(0.01 * k, DepthSample{7.0}));
  }
  ASSERT_EQ(estimator.Odometry().size(), 501U);
  EXPECT_LT((estimator.Latest()->state.T_WI.p() - Eigen::Vector3d(1, 2, 3)).norm(), 1e-9);
}

// Recordings begin before their ground truth does: the body was elsewhere then.
TEST(DeadReckoning, IgnoresWhatWasMeasuredBeforeItsStart) {
  DeadReckoning estimator(Rig{});
  NavState known;
  known.t = Time::FromSeconds(2.0);
  known.v_W = {0.0, 0.0, 0.5};
  estimator.Start(known);
  estimator.Add(At(0.0, DepthSample{9.0}));
  estimator.Add(At(1.0, ImuSample{{1, 1, 1}, {5, 5, 5}}));
  EXPECT_FALSE(estimator.Latest());
  // From here on the depth readings agree with the known speed upwards.
  for (int k = 0; k <= 100; ++k) {
    estimator.Add(At(2.0 + 0.01 * k, kRest));
    if (k % 50 == 0) estimator.Add(At(2.0 + 0.01 * k, DepthSample{7.0 - 0.005 * k}));
  }
  EXPECT_NEAR(estimator.Latest()->state.T_WI.p().z(), 0.5, 1e-9);
}

TEST(DeadReckoning, DepthHoldsTheHeight) {
  ImuSample biased = kRest;
  biased.specific_force.z() += 0.02;  // Unknown to the estimator: 36 m in 60 s.
  DeadReckoning estimator(Rig{});
  estimator.Start(NavState{});
  for (int k = 0; k <= 6000; ++k) {
    estimator.Add(At(0.01 * k, biased));
    if (k % 100 == 0) estimator.Add(At(0.01 * k, DepthSample{7.0}));
  }
  EXPECT_LT(std::abs(estimator.Latest()->state.T_WI.p().z()), 0.03);
}

// A pressure sensor's zero may be wrong by metres: what counts is the change since the first
// reading.
TEST(DeadReckoning, AConstantOffsetOfDepthChangesNothing) {
  Rig rig;
  rig.depth.p_ID = {-0.3, 0.1, 0.05};
  NavState known;  // Nose down, so that the port is above I by its lever arm.
  known.T_WI = Pose(FromYawPitchRoll(0.3, 0.4, 0.0), {1, 2, 3});
  ImuSample sample;
  sample.specific_force = known.T_WI.q().conjugate() * Eigen::Vector3d(0, 0, 9.81 - 0.002);
  const auto height_at_the_end = [&](double offset) {
    DeadReckoning estimator(rig);
    estimator.Start(known);
    for (int k = 0; k <= 6000; ++k) {
      const double t = 0.01 * k;
      estimator.Add(At(t, sample));
      if (k % 100 == 0) estimator.Add(At(t, DepthSample{offset + 0.5 * 0.002 * t * t}));
    }
    return estimator.Latest()->state.T_WI.p().z();
  };
  const double without = height_at_the_end(0.0);
  EXPECT_NEAR(without, 3.0 - 3.6, 1e-6);  // 0.002 m/s^2 for 60 s.
  EXPECT_NEAR(height_at_the_end(2.0), without, 1e-9);
  EXPECT_NEAR(height_at_the_end(-0.7), without, 1e-9);
}

TEST(DeadReckoning, NonsenseIsIgnored) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  DeadReckoning estimator(Rig{});
  estimator.Start(NavState{});
  estimator.Add(At(0.0, kRest));
  estimator.Add(At(0.01, ImuSample{{kNan, 0, 0}, {0, 0, 9.81}}));
  estimator.Add(At(0.01, DepthSample{kNan}));
  estimator.Add(At(0.02, kRest));
  estimator.Add(At(0.01, kRest));  // Runs backwards.
  estimator.Add(At(0.02, kRest));  // Says the same instant again.
  estimator.Add(At(0.03, StereoFrame{}));
  EXPECT_EQ(estimator.Odometry().size(), 2U);
  EXPECT_TRUE(estimator.Latest()->state.T_WI.p().allFinite());
}

}  // namespace
}  // namespace drydock
