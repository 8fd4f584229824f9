#include "sensors_models/base/pose.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-14;

Vector3d RandomVector(RandomStream& random, double size) {
  return {random.Uniform(-size, size), random.Uniform(-size, size), random.Uniform(-size, size)};
}

Vector3d RandomDirection(RandomStream& random) {
  return Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian()).normalized();
}

Pose RandomPose(RandomStream& random) {
  return {ExpSO3(random.Uniform(0.0, kPi) * RandomDirection(random)), RandomVector(random, 5.0)};
}

double Distance(const Pose& a, const Pose& b) { return a.BoxMinus(b).norm(); }

TEST(Skew, IsTheCrossProduct) {
  const Vector3d a(1.0, -2.0, 3.0);
  const Vector3d b(-4.0, 5.0, 6.0);
  EXPECT_EQ(Skew(a) * b, a.cross(b));
}

TEST(SO3, ExpOfAQuarterTurnAboutZ) {
  const Quaterniond q = ExpSO3({0.0, 0.0, kPi / 2});
  EXPECT_NEAR((q * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 0.0, kTolerance);
}

TEST(SO3, LogInvertsExpFromTinyToHalfATurn) {
  RandomStream random(1, "log");
  for (const double angle : {0.0, 1e-300, 1e-12, 9.9e-8, 1.01e-7, 9.9e-5, 1.01e-4, 1e-3, 0.5, 1.0,
                             2.0, 3.0, kPi - 1e-4, kPi - 1e-9}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3d phi = angle * RandomDirection(random);
      const Quaterniond q = ExpSO3(phi);
      EXPECT_NEAR(q.norm(), 1.0, kTolerance) << angle;
      EXPECT_NEAR((LogSO3(q) - phi).norm(), 0.0, kTolerance * std::max(angle, 1e-10)) << angle;
    }
  }
}

TEST(SO3, LogTakesTheShortWayForEitherSignOfTheQuaternion) {
  RandomStream random(2, "sign");
  for (int i = 0; i < 100; ++i) {
    const Quaterniond q = RandomPose(random).q();
    const Quaterniond opposite(-q.w(), -q.x(), -q.y(), -q.z());
    EXPECT_NEAR((LogSO3(q) - LogSO3(opposite)).norm(), 0.0, kTolerance);
    EXPECT_LE(LogSO3(opposite).norm(), kPi + kTolerance);
  }
  EXPECT_NEAR(LogSO3(Quaterniond(-1.0, 1e-9, 0.0, 0.0)).x(), -2e-9, 1e-24);
}

TEST(SO3, LogOfHalfATurn) {
  EXPECT_NEAR(LogSO3(Quaterniond(0.0, 0.0, 1.0, 0.0)).y(), kPi, kTolerance);
  EXPECT_NEAR(LogSO3(ExpSO3({kPi, 0.0, 0.0})).norm(), kPi, kTolerance);
  // Beyond half a turn the same rotation is reached the other way round.
  EXPECT_NEAR(LogSO3(ExpSO3({0.0, 0.0, kPi + 0.1})).z(), -(kPi - 0.1), kTolerance);
}

TEST(SO3, LeftJacobianIsTheInversesInverse) {
  RandomStream random(4, "jacobian");
  for (const double angle : {0.0, 1e-6, 5e-3, 9.99e-3, 0.0101, 0.1, 1.0, 2.5, 3.0}) {
    const Vector3d phi = angle * RandomDirection(random);
    const Eigen::Matrix3d product = LeftJacobianSO3(phi) * LeftJacobianInverseSO3(phi);
    // The series stop where a term would be 1e-11 (0.01^4 / 720), the quotients lose digits there.
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 3e-11) << angle;
  }
}

TEST(SO3, LeftJacobianInverseMatchesDifferences) {
  RandomStream random(3, "jacobian");
  constexpr double kStep = 1e-6;
  for (const double angle : {0.0, 1e-6, 9e-4, 1.1e-3, 0.1, 1.0, 2.5, 3.0}) {
    const Vector3d phi = angle * RandomDirection(random);
    Eigen::Matrix3d numeric;
    for (int i = 0; i < 3; ++i) {
      const Vector3d d = kStep * Vector3d::Unit(i);
      numeric.col(i) =
          (LogSO3(ExpSO3(d) * ExpSO3(phi)) - LogSO3(ExpSO3(-d) * ExpSO3(phi))) / (2.0 * kStep);
    }
    // Central differences: truncation 1e-12, rounding 1e-16/1e-6.
    EXPECT_LT((LeftJacobianInverseSO3(phi) - numeric).norm(), 2e-9) << angle;
  }
}

TEST(SO3, LeftJacobianInverseIsSmoothWhereTheFormulaChanges) {
  const Vector3d direction = Vector3d(1.0, 2.0, -1.0).normalized();
  const auto below = LeftJacobianInverseSO3(direction * (1e-3 * (1 - 1e-12)));
  const auto above = LeftJacobianInverseSO3(direction * (1e-3 * (1 + 1e-12)));
  EXPECT_LT((below - above).norm(), 1e-13);
}

TEST(YawPitchRoll, PositivePitchLooksDownAndYawTurnsLeft) {
  const Quaterniond down = FromYawPitchRoll(0.0, 0.3, 0.0);
  EXPECT_LT((down * Vector3d::UnitX()).z(), 0.0);
  const Quaterniond left = FromYawPitchRoll(0.3, 0.0, 0.0);
  EXPECT_GT((left * Vector3d::UnitX()).y(), 0.0);
  const Quaterniond right_side_down = FromYawPitchRoll(0.0, 0.0, 0.3);
  EXPECT_GT((right_side_down * Vector3d::UnitY()).z(), 0.0);
}

TEST(YawPitchRoll, YawComesBackWhateverTheTilt) {
  for (const double yaw : {-3.0, -1.0, 0.0, 0.5, 3.1}) {
    EXPECT_NEAR(YawOf(FromYawPitchRoll(yaw, 1.2, -2.0)), yaw, kTolerance);
  }
}

TEST(YawPitchRoll, YawBetweenAsksNotWhichAxisIsForward) {
  // Level, as EuRoC's body with x up, and tilted.
  for (const Quaterniond& q : {Quaterniond::Identity(), FromYawPitchRoll(0.2, -kPi / 2, 0.1),
                               FromYawPitchRoll(-2.0, 0.4, 2.5)}) {
    for (const double yaw : {-3.0, -1.0, 0.0, 0.5, 3.1}) {
      EXPECT_NEAR(YawBetween(q, FromYawPitchRoll(yaw, 0.0, 0.0) * q), yaw, kTolerance);
    }
  }
}

TEST(YawPitchRoll, YawBetweenLeavesTheLeastTurn) {
  const Quaterniond from = FromYawPitchRoll(0.3, 0.2, -0.1), to = FromYawPitchRoll(2.0, -0.4, 0.3);
  const double best = YawBetween(from, to);
  const auto left = [&](double yaw) {
    return (FromYawPitchRoll(yaw, 0.0, 0.0) * from).angularDistance(to);
  };
  EXPECT_LT(left(best), left(best + 1e-3));
  EXPECT_LT(left(best), left(best - 1e-3));
}

TEST(Pose, GroupLaws) {
  RandomStream random(4, "group");
  for (int i = 0; i < 200; ++i) {
    const Pose a = RandomPose(random);
    const Pose b = RandomPose(random);
    const Pose c = RandomPose(random);
    const Vector3d x = RandomVector(random, 5.0);
    EXPECT_LT(Distance((a * b) * c, a * (b * c)), 1e-13);
    EXPECT_LT(Distance(a * a.Inverse(), Pose()), 1e-13);
    EXPECT_LT(Distance(a.Inverse() * a, Pose()), 1e-13);
    EXPECT_LT(Distance(a * Pose::Identity(), a), 1e-15);
    EXPECT_LT(((a * b) * x - a * (b * x)).norm(), 1e-13);
    EXPECT_LT((a * x - (a.R() * x + a.p())).norm(), 1e-13);
  }
}

TEST(Pose, BoxMinusInvertsBoxPlus) {
  RandomStream random(5, "box");
  for (int i = 0; i < 200; ++i) {
    const Pose a = RandomPose(random);
    const Pose b = RandomPose(random);
    Vector6d delta;
    delta << RandomVector(random, 2.0), random.Uniform(0.0, 3.1) * RandomDirection(random);
    EXPECT_LT((a.BoxPlus(delta).BoxMinus(a) - delta).norm(), 1e-13);
    EXPECT_LT(Distance(b.BoxPlus(a.BoxMinus(b)), a), 1e-13);
  }
}

TEST(Pose, BoxPlusTurnsInTheOuterFrame) {
  const Pose facing_left(FromYawPitchRoll(kPi / 2, 0.0, 0.0), Vector3d(1.0, 2.0, 3.0));
  Vector6d delta;
  delta << 0.0, 0.0, 0.0, kPi / 2, 0.0, 0.0;  // About the world's x axis, on the spot.
  const Pose moved = facing_left.BoxPlus(delta);
  EXPECT_NEAR((moved.q() * Vector3d::UnitX() - Vector3d::UnitZ()).norm(), 0.0, kTolerance);
  EXPECT_EQ(moved.p(), facing_left.p());
}

TEST(Pose, NormalisesOnceAndThenKeepsItsBits) {
  RandomStream random(6, "normalise");
  for (int i = 0; i < 10'000; ++i) {
    const Quaterniond raw(random.Gaussian(), random.Gaussian(), random.Gaussian(),
                          random.Gaussian());
    const Pose once(raw, Vector3d::Zero());
    const Pose twice(once.q(), Vector3d::Zero());
    ASSERT_NEAR(once.q().norm(), 1.0, 1e-15);
    ASSERT_EQ(once.q().coeffs(), twice.q().coeffs());
  }
}

TEST(Pose, LongChainsStayRotations) {
  const Pose step(ExpSO3({0.01, -0.02, 0.03}), Vector3d(0.1, 0.0, 0.0));
  Pose pose;
  for (int i = 0; i < 100'000; ++i) pose = pose * step;
  EXPECT_NEAR(pose.q().norm(), 1.0, 1e-15 * 8);
}

}  // namespace
}  // namespace drydock
