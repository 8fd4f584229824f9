#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/sonar_range_factor.h"
#include "estimator/svin2/loop/fixed_pose_factor.h"
#include "estimator/svin2/loop/recognised_point_factor.h"
#include "tests/estimator/svin2/factors/factor_check.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

const Pose kPose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});
const Vector3d kPoint(2.5, 0.4, -0.3);  // In the body's frame.

RecognisedPointFactor Recognised(const Vector2d& error_left, const Vector2d& error_right) {
  const StereoGeometry rig(testing::SyntheticStereo());
  return {rig, *testing::PixelOf(rig, 0, kPoint) + error_left,
          *testing::PixelOf(rig, 1, kPoint) + error_right, 0.2, 0.5};
}

TEST(RecognisedPointFactor, WhitensByTheCovarianceThatItNames) {
  const Blocks states = {Block(ToParameters(kPose)), Block(Vector3d(kPose * kPoint))};
  EXPECT_LT(testing::Residuals(Recognised({0, 0}, {0, 0}), states).norm(), 1e-9);
  const Vector2d left(0.7, -0.3), right(0.4, 0.2);
  const Eigen::VectorXd e = testing::Residuals(Recognised(left, right), states);
  Eigen::Vector4d errors;
  errors << left, right;
  Eigen::Matrix4d covariance = 0.2 * 0.2 * Eigen::Matrix4d::Identity();
  for (int block = 0; block < 4; ++block)
    covariance.block<2, 2>(2 * (block / 2), 2 * (block % 2)) +=
        0.5 * 0.5 * Eigen::Matrix2d::Identity();
  EXPECT_NEAR(e.squaredNorm(), errors.dot(covariance.inverse() * errors), 1e-9);
}

TEST(RecognisedPointFactor, JacobiansMatchDifferences) {
  const Blocks states = {Block(ToParameters(kPose)), Block(Vector3d(kPose * kPoint))};
  EXPECT_LT(testing::WorstJacobianError(Recognised({2, -3}, {1, 4}), states, 1e-5), 1e-6);
}

TEST(RecognisedPointFactor, RefusesAKeypointWithoutUncertainty) {
  const StereoGeometry rig(testing::SyntheticStereo());
  EXPECT_THROW(RecognisedPointFactor(rig, {1, 1}, {1, 1}, 0.0, 1.0), std::logic_error);
  EXPECT_THROW(RecognisedPointFactor(rig, {1, 1}, {1, 1}, 0.1, -1.0), std::logic_error);
}

TEST(FixedPoseFactor, IsTheFactorWithThatPose) {
  SonarRangeObservation observation;
  observation.range = 2.0;
  observation.p_IS = {0.13, 0.02, 0.12};
  observation.sigma_range = 0.02;
  const SonarRangeFactor free(observation, 2);
  const FixedPoseFactor fixed(std::make_unique<SonarRangeFactor>(observation, 2), kPose);
  const Blocks landmarks = {Block(Vector3d(2, 3, -3)), Block(Vector3d(2.2, 3.1, -2.5))};
  Blocks all = {Block(ToParameters(kPose))};
  all.insert(all.end(), landmarks.begin(), landmarks.end());
  EXPECT_EQ(fixed.parameter_block_sizes(), (std::vector<int>{3, 3}));
  EXPECT_EQ(testing::Residuals(fixed, landmarks), testing::Residuals(free, all));
  EXPECT_LT(testing::WorstJacobianError(fixed, landmarks, 1e-5), 1e-6);
}

TEST(FixedPoseFactor, RefusesAFactorWithoutPose) {
  SonarRangeObservation observation;
  observation.sigma_range = 0.02;
  auto inner =
      std::make_unique<FixedPoseFactor>(std::make_unique<SonarRangeFactor>(observation, 2), kPose);
  EXPECT_THROW(FixedPoseFactor(std::move(inner), kPose), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
