#include "sensors_models/base/pose_manifold.h"

#include <ceres/manifold_test_utils.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock {
namespace {

using ceres::Vector;

constexpr double kTolerance = 1e-9;

Vector RandomPoint(RandomStream& random) {
  Vector x(7);
  for (int i = 0; i < 7; ++i) x[i] = random.Gaussian();
  x.tail<4>().normalize();
  return x;
}

TEST(PoseManifold, KeepsTheInvariantsOfAManifold) {
  const PoseManifold manifold;
  RandomStream random(1, "manifold");
  for (int i = 0; i < 200; ++i) {
    const Vector x = RandomPoint(random);
    const Vector y = RandomPoint(random);
    Vector delta(6);
    for (int k = 0; k < 6; ++k) delta[k] = 0.5 * random.Gaussian();
    EXPECT_THAT(manifold, ceres::XPlusZeroIsXAt(x, kTolerance));
    EXPECT_THAT(manifold, ceres::XMinusXIsZeroAt(x, kTolerance));
    EXPECT_THAT(manifold, ceres::MinusPlusIsIdentityAt(x, delta, kTolerance));
    EXPECT_THAT(manifold, ceres::HasCorrectPlusJacobianAt(x, kTolerance));
    EXPECT_THAT(manifold, ceres::HasCorrectMinusJacobianAt(x, kTolerance));
    EXPECT_THAT(manifold, ceres::MinusPlusJacobianIsIdentityAt(x, kTolerance));
    // x + (y - x) is y up to the quaternion's sign, which the matcher does not know.
    const Pose to = FromParameters(y.data());
    const Pose from = FromParameters(x.data());
    EXPECT_LT(from.BoxPlus(to.BoxMinus(from)).BoxMinus(to).norm(), 1e-13);
  }
}

TEST(PoseManifold, IsPosesOwnBoxPlus) {
  const PoseManifold manifold;
  const Pose pose(ExpSO3({0.1, -0.5, 1.0}), {1.0, 2.0, 3.0});
  Vector6d delta;
  delta << 0.1, -0.2, 0.3, 0.4, 0.5, -0.6;
  const PoseParameters x = ToParameters(pose);
  PoseParameters moved{};
  ASSERT_TRUE(manifold.Plus(x.data(), delta.data(), moved.data()));
  EXPECT_LT(FromParameters(moved.data()).BoxMinus(pose.BoxPlus(delta)).norm(), 1e-15);
  Vector6d back;
  ASSERT_TRUE(manifold.Minus(moved.data(), x.data(), back.data()));
  EXPECT_LT((back - delta).norm(), 1e-14);
}

TEST(PoseManifold, ParametersHoldThePoseInCeresOrder) {
  const Pose pose(Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), {1.0, 2.0, 3.0});
  const PoseParameters x = ToParameters(pose);
  EXPECT_THAT(x, testing::ElementsAre(1.0, 2.0, 3.0, 0.5, -0.5, 0.5, 0.5));
  EXPECT_EQ(FromParameters(x.data()).q().coeffs(), pose.q().coeffs());
}

}  // namespace
}  // namespace drydock
