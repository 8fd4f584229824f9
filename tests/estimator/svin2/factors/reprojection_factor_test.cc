#include "estimator/svin2/factors/reprojection_factor.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"
#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

CameraModel Camera(const std::array<double, 4>& distortion = {-0.16, 0.102, 0.0013, -0.0021}) {
  CameraIntrinsics camera;
  camera.width = 800;
  camera.height = 600;
  camera.fx = 575.0;
  camera.fy = 574.0;
  camera.cx = 399.0;
  camera.cy = 288.0;
  camera.distortion = distortion;
  return CameraModel(camera);
}

/// The camera looks along the body's x.
Pose Extrinsics() {
  Eigen::Matrix3d R_IC;
  R_IC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(R_IC), {0.04, 0.084, -0.005}};
}

const Pose kPose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});

Blocks States(const Pose& T_WI, const Vector3d& landmark) {
  return {Block(ToParameters(T_WI)), Block(landmark)};
}

TEST(ReprojectionFactor, ValueByHand) {
  // At 2 m ahead, 0.2 m right and 0.1 m below the axis of a lens without distortion: 57.5 px right
  // of and 28.7 px below the principal point. Seen 1 px further right and 2 px further up.
  const Vector3d landmark(0.04 + 2.0, 0.084 - 0.2, -0.005 - 0.1);
  const ReprojectionFactor factor(Camera({}), Extrinsics(), {399 + 58.5, 288 + 26.7}, 0.5);
  const Eigen::VectorXd e = testing::Residuals(factor, States(Pose(), landmark));
  EXPECT_NEAR(e[0], 1.0 / 0.5, 1e-9);
  EXPECT_NEAR(e[1], -2.0 / 0.5, 1e-9);
}

TEST(ReprojectionFactor, VanishesAtTruthAndItsJacobiansMatchDifferences) {
  RandomStream random(1, "reprojection");
  for (int i = 0; i < 100; ++i) {
    const double z = random.Uniform(0.5, 12.0);
    const double x = random.Uniform(-0.6, 0.6) * z;
    const double y = random.Uniform(-0.45, 0.45) * z;
    const Vector3d landmark = kPose * (Extrinsics() * Vector3d(x, y, z));
    const Vector2d pixel = *Camera().Project({x, y, z});
    const Blocks states = States(kPose, landmark);
    const ReprojectionFactor exact(Camera(), Extrinsics(), pixel, 0.8);
    EXPECT_LT(testing::Residuals(exact, states).norm(), 1e-9);
    const ReprojectionFactor factor(Camera(), Extrinsics(), pixel + Vector2d(3, -5), 0.8);
    EXPECT_LT(testing::WorstJacobianError(factor, states, 1e-5), 1e-6);
  }
}

TEST(ReprojectionFactor, BehindTheCameraItNeitherPullsNorBreaks) {
  const ReprojectionFactor factor(Camera(), Extrinsics(), {400, 300}, 2.0);
  // Behind, in the camera's plane, and at its centre.
  for (const Vector3d& p_C :
       {Vector3d(0.1, 0.1, -2.0), Vector3d(0.1, 0.1, 0.0), Vector3d(0, 0, 0)}) {
    const Blocks states = States(kPose, kPose * (Extrinsics() * p_C));
    EXPECT_EQ(testing::Residuals(factor, states), Vector2d(700.0, 0.0));
    for (const auto& jacobian : testing::TangentJacobians(factor, states))
      EXPECT_EQ(jacobian.norm(), 0.0);
  }
}

TEST(ReprojectionFactor, RefusesAKeypointWithoutUncertainty) {
  EXPECT_THROW(ReprojectionFactor(Camera(), Extrinsics(), {400, 300}, 0.0), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
