#include "estimator/svin2/factors/sonar_range_factor.h"

#include <cmath>
#include <stdexcept>

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <gtest/gtest.h>

#include "sensors_models/models/sonar_model.h"
#include "tests/estimator/svin2/factors/factor_check.h"
#include "tests/estimator/svin2/synthetic_motion.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

const Vector3d kHead(0.128, 0.016, 0.125);

SonarRangeObservation Observation(double range) {
  SonarRangeObservation observation;
  observation.range = range;
  observation.p_IS = kHead;
  observation.sigma_range = 0.03;
  observation.sigma_patch = 0.04;
  return observation;
}

TEST(SonarRangeFactor, ValueAndDerivativesByHand) {
  // The head is at (0.128, 0.016, 0.125), the patch's mean 2 m above it: 2.1 m were measured, 0.1 m
  // too much, at a standard deviation of 0.05 m (3-4-5).
  const SonarRangeFactor factor(Observation(2.1), 2);
  const Blocks states = {Block(ToParameters(Pose())), Block(Vector3d(0.028, 0.216, 2.125)),
                         Block(Vector3d(0.228, -0.184, 2.125))};
  EXPECT_NEAR(testing::Residuals(factor, states)[0], 0.1 / 0.05, 1e-12);
  const auto jacobians = testing::TangentJacobians(factor, states);
  Eigen::Matrix<double, 1, 6> by_pose;
  // u = -z, and u' [s]x = (u x s)' = (s_y, -s_x, 0). Up is nearer, so the error grows.
  by_pose << 0, 0, 1, 0.016, -0.128, 0;
  EXPECT_LT((jacobians[0] - by_pose / 0.05).norm(), 1e-12);
  EXPECT_LT((jacobians[1] - Eigen::RowVector3d(0, 0, -0.5) / 0.05).norm(), 1e-12);
  EXPECT_EQ(jacobians[1], jacobians[2]);
}

TEST(SonarRangeFactor, HeldLandmarksCountInTheMeanAndGoWithTheAnchor) {
  // As above with the first landmark held, and with both; the anchor is 1 m behind, turned by 90
  // degrees to the left.
  const Pose anchor(FromYawPitchRoll(0.5 * M_PI, 0, 0), {-1, 0, 0});
  const Vector3d first(0.028, 0.216, 2.125), second(0.228, -0.184, 2.125);
  SonarRangeObservation observation = Observation(2.1);
  observation.held_landmarks = {anchor.Inverse() * first};
  const SonarRangeFactor one(observation, 1);
  const Blocks states = {Block(ToParameters(Pose())), Block(ToParameters(anchor)), Block(second)};
  EXPECT_NEAR(testing::Residuals(one, states)[0], 0.1 / 0.05, 1e-12);
  const auto jacobians = testing::TangentJacobians(one, states);
  EXPECT_LT((jacobians[2] - Eigen::RowVector3d(0, 0, -0.5) / 0.05).norm(), 1e-12);
  Eigen::Matrix<double, 1, 6> by_anchor;
  // The landmark lies at s = (1.028, 0.216, 2.125) from the anchor; u = -z, and -u' [s]x =
  // -(s_y, -s_x, 0).
  by_anchor << 0, 0, -0.5, -0.5 * 0.216, 0.5 * 1.028, 0;
  EXPECT_LT((jacobians[1] - by_anchor / 0.05).norm(), 1e-12);
  observation.held_landmarks.push_back(anchor.Inverse() * second);
  const SonarRangeFactor none(observation, 0);
  EXPECT_NEAR(testing::Residuals(none, {states[0], states[1]})[0], 0.1 / 0.05, 1e-12);
}

TEST(SonarRangeFactor, SaysNothingOfWhereBothPosesAre) {
  // Moved and turned about the vertical together, with all landmarks held: no difference.
  SonarRangeObservation observation = Observation(2.5);
  observation.held_landmarks = {Vector3d(2.0, 3.5, -1.0), Vector3d(2.1, 3.4, -1.1)};
  const SonarRangeFactor factor(observation, 0);
  const Pose pose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3}), anchor({1, 0, 0, 0}, {0, 1, -3});
  const Pose moved(FromYawPitchRoll(0.3, 0, 0), {5, -4, 1});
  EXPECT_NEAR(
      testing::Residuals(factor, {Block(ToParameters(pose)), Block(ToParameters(anchor))})[0],
      testing::Residuals(
          factor, {Block(ToParameters(moved * pose)), Block(ToParameters(moved * anchor))})[0],
      1e-9);
}

TEST(SonarRangeFactor, VanishesAtTheEchoSeenAtThePingsOwnTime) {
  // A ping 25 ms after the frame, and a patch of four whose mean is the echo.
  const NavState frame = testing::MotionAt({1'000'000'000});
  const NavState ping = testing::MotionAt({1'025'000'000});
  const Pose T_IS(ExpSO3({0.3, 1.2, -0.4}), kHead);
  const Vector3d echo = ping.T_WI * (T_IS * SonarPoint(0.7, 3.2));
  SonarRangeObservation observation = Observation(3.2);
  observation.T_frame_ping = frame.T_WI.Inverse() * ping.T_WI;
  const SonarRangeFactor factor(observation, 4);
  const Blocks states = {Block(ToParameters(frame.T_WI)), Block(echo + Vector3d(0.1, 0.05, 0)),
                         Block(echo - Vector3d(0.1, 0.05, 0)), Block(echo + Vector3d(0, 0, 0.1)),
                         Block(echo - Vector3d(0, 0, 0.1))};
  EXPECT_LT(std::abs(testing::Residuals(factor, states)[0]), 1e-9);
  // Posed at the frame's time instead it is off by millimetres.
  observation.T_frame_ping = Pose();
  EXPECT_GT(std::abs(testing::Residuals(SonarRangeFactor(observation, 4), states)[0]) * 0.05, 1e-3);
}

TEST(SonarRangeFactor, JacobiansMatchDifferences) {
  const Pose pose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});
  const Pose anchor(FromYawPitchRoll(0.2, 0.1, -0.2), {0.5, 1, -3});
  for (const std::size_t held : {0, 1, 3}) {
    for (std::size_t landmarks = held == 0 ? 1 : 0; landmarks <= 7; ++landmarks) {
      SonarRangeObservation observation = Observation(2.5);
      observation.T_frame_ping = Pose(ExpSO3({0.1, -0.2, 0.3}), {0.1, 0.2, 0.3});
      for (std::size_t k = 0; k < held; ++k)
        observation.held_landmarks.emplace_back(1.5, 2.5 - 0.1 * static_cast<double>(k), 1.0);
      Blocks states = {Block(ToParameters(pose))};
      if (held > 0) states.push_back(Block(ToParameters(anchor)));
      for (std::size_t k = 0; k < landmarks; ++k) {
        const auto offset = static_cast<double>(k);
        states.push_back(Block(Vector3d(2.0 + 0.1 * offset, 3.5, -2.0 - 0.05 * offset)));
      }
      EXPECT_LT(testing::WorstJacobianError(SonarRangeFactor(observation, landmarks), states),
                1e-6);
    }
  }
}

TEST(SonarRangeFactor, APatchAtTheHeadHasNoDirection) {
  const SonarRangeFactor factor(Observation(0.5), 1);
  const Blocks states = {Block(ToParameters(Pose())), Block(kHead)};
  EXPECT_NEAR(testing::Residuals(factor, states)[0], 0.5 / 0.05, 1e-12);
  for (const auto& jacobian : testing::TangentJacobians(factor, states))
    EXPECT_EQ(jacobian.norm(), 0.0);
}

TEST(SonarRangeFactor, CorrectsTheScaleOfItsLandmarks) {
  // With the pose held and weak priors on the landmarks, the patch moves out to the echo.
  PoseParameters pose = ToParameters(Pose());
  std::array<std::array<double, 3>, 2> landmarks = {{{0.1, 0.1, 1.8}, {0.15, -0.07, 1.8}}};
  SonarRangeObservation observation = Observation(2.0);
  observation.p_IS.setZero();
  ceres::Problem problem;
  problem.AddParameterBlock(pose.data(), 7, new PoseManifold);
  problem.SetParameterBlockConstant(pose.data());
  problem.AddResidualBlock(new SonarRangeFactor(observation, 2), nullptr, pose.data(),
                           landmarks[0].data(), landmarks[1].data());
  ceres::Solver::Options options;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const Vector3d mean =
      0.5 * (Eigen::Map<Vector3d>(landmarks[0].data()) + Eigen::Map<Vector3d>(landmarks[1].data()));
  EXPECT_NEAR(mean.norm(), 2.0, 1e-6);
}

TEST(SonarRangeFactor, RefusesWhatHasNoInformation) {
  EXPECT_THROW(SonarRangeFactor(Observation(2.0), 0), std::logic_error);
  SonarRangeObservation observation = Observation(2.0);
  observation.sigma_range = 0.0;
  EXPECT_THROW(SonarRangeFactor(observation, 1), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
