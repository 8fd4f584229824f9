#include "scenarios/scoring/consistency.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::score {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A tumbling climb, a pose each 10 ms.
Trajectory Tumble(int count) {
  Trajectory truth;
  for (int i = 0; i < count; ++i) {
    const double t = 0.01 * i;
    truth.push_back({Time::FromSeconds(t),
                     Pose(FromYawPitchRoll(0.3 * t, 0.4 * std::sin(t), 0.2 * std::cos(2.0 * t)),
                          {t, std::sin(t), 0.1 * t})});
  }
  return truth;
}

/// What an estimator believes whose world is turned and moved, and that errs by `error` there.
Belief Believe(const StampedPose& truth, const Vector6d& error, const Matrix6d& covariance,
               int map_id = 0) {
  const Pose T_world(FromYawPitchRoll(0.5 * std::numbers::pi + map_id, 0.0, 0.0), {5.0, -3.0, 1.0});
  return {truth.t, (T_world * truth.T_WI).BoxPlus(error), covariance, map_id};
}

// Errors of one and two standard deviations along one axis each, whose variances are those of the
// estimator's axes: 1 / 3 and 4 / 3. Its world is turned by 90 degrees: taken along the truth's
// axes the position's would be 0.04 / 3.
TEST(Anees, IsNormalisedInTheWorldOfTheCovariance) {
  const Trajectory truth = Tumble(2);
  Matrix6d covariance = Matrix6d::Identity();
  covariance(0, 0) = 0.04;
  covariance(5, 5) = 0.0025;
  Vector6d error = Vector6d::Zero();
  error[0] = 0.2;
  error[5] = 0.1;
  const auto anees = ComputeAnees(truth, {Believe(truth[0], Vector6d::Zero(), covariance),
                                          Believe(truth[1], error, covariance)});
  ASSERT_TRUE(anees);
  EXPECT_EQ(anees->count, 1U) << "the first is laid upon the truth";
  EXPECT_NEAR(anees->position, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(anees->orientation, 4.0 / 3.0, 1e-9);
}

// e^T P^-1 e of three Gaussian numbers is chi-square with 3 degrees of freedom: mean 3, variance 6.
// The mean of 4000, a third of each, scatters by sqrt(6 / 4000) / 3 = 0.013: five times that is
// allowed.
TEST(Anees, IsOneForAnEstimatorThatKnowsItsErrors) {
  constexpr int kCount = 4001;
  const Trajectory truth = Tumble(kCount);
  RandomStream random(7, "anees");
  Matrix6d root;
  for (int i = 0; i < 36; ++i) root(i) = 0.02 * random.Gaussian();
  const Matrix6d covariance = root * root.transpose() + 1e-4 * Matrix6d::Identity();
  const Matrix6d factor = covariance.llt().matrixL();
  std::vector<Belief> right = {Believe(truth[0], Vector6d::Zero(), covariance)};
  std::vector<Belief> vain = right;
  for (int i = 1; i < kCount; ++i) {
    Vector6d normal;
    for (int k = 0; k < 6; ++k) normal[k] = random.Gaussian();
    right.push_back(Believe(truth[i], factor * normal, covariance));
    vain.push_back(Believe(truth[i], factor * normal, 0.25 * covariance));
  }
  const auto anees = ComputeAnees(truth, right);
  ASSERT_TRUE(anees);
  EXPECT_EQ(anees->count, 4000U);
  EXPECT_NEAR(anees->position, 1.0, 0.065);
  EXPECT_NEAR(anees->orientation, 1.0, 0.065);
  const auto too_sure = ComputeAnees(truth, vain);
  EXPECT_NEAR(too_sure->position, 4.0 * anees->position, 1e-9);
  EXPECT_NEAR(too_sure->orientation, 4.0 * anees->orientation, 1e-9);
}

TEST(Anees, EachMapIsLaidUponTheTruthByItself) {
  const Trajectory truth = Tumble(4);
  const Matrix6d covariance = Matrix6d::Identity();
  const auto anees = ComputeAnees(truth, {Believe(truth[0], Vector6d::Zero(), covariance, 0),
                                          Believe(truth[1], Vector6d::Zero(), covariance, 0),
                                          Believe(truth[2], Vector6d::Zero(), covariance, 1),
                                          Believe(truth[3], Vector6d::Zero(), covariance, 1)});
  ASSERT_TRUE(anees);
  EXPECT_EQ(anees->count, 2U);
  EXPECT_NEAR(anees->position, 0.0, 1e-20);
  EXPECT_NEAR(anees->orientation, 0.0, 1e-20);
}

TEST(Anees, WhatCannotBeJudgedIsLeftOut) {
  const Trajectory truth = Tumble(3);
  Matrix6d flat = Matrix6d::Identity();
  flat(2, 2) = 0.0;
  const Belief first = Believe(truth[0], Vector6d::Zero(), flat);
  Belief late = first;
  late.t = Time::FromSeconds(1.0);
  EXPECT_FALSE(ComputeAnees(truth, {}));
  EXPECT_FALSE(ComputeAnees(truth, {first}));
  EXPECT_FALSE(ComputeAnees(truth, {first, Believe(truth[1], Vector6d::Zero(), flat), late}));
}

}  // namespace
}  // namespace drydock::score
