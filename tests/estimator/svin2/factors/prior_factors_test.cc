#include "estimator/svin2/factors/prior_factors.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;

const Pose kPose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});

Vector6d Sigmas() {
  Vector6d sigmas;
  sigmas << 0.1, 0.2, 0.4, 0.01, 0.02, 0.05;
  return sigmas;
}

TEST(PosePriorFactor, ValueByHand) {
  const PosePriorFactor factor(kPose, PoseWhitening(Sigmas()));
  Vector6d delta;
  delta << 0.1, -0.1, 0.1, 0.1, 0.0, 0.0;
  const Eigen::VectorXd e = testing::Residuals(factor, {Block(ToParameters(kPose.BoxPlus(delta)))});
  Vector6d expected;
  expected << 1.0, -0.5, 0.25, 10.0, 0.0, 0.0;
  EXPECT_LT((e - expected).norm(), 1e-12);
}

TEST(PosePriorFactor, VanishesAtItsPoseWhateverTheQuaternionsSign) {
  const PosePriorFactor factor(kPose, PoseWhitening(Sigmas()));
  PoseParameters pose = ToParameters(kPose);
  EXPECT_LT(testing::Residuals(factor, {Block(pose)}).norm(), 1e-12);
  for (std::size_t k = 3; k < 7; ++k) pose[k] = -pose[k];
  EXPECT_LT(testing::Residuals(factor, {Block(pose)}).norm(), 1e-12);
}

TEST(PosePriorFactor, JacobianMatchesDifferences) {
  Eigen::Matrix<double, 6, 6> whitening = PoseWhitening(Sigmas());
  whitening(0, 5) = 3.0;
  whitening(4, 1) = -2.0;
  Vector6d delta;
  delta << 0.1, -0.1, 0.1, 0.5, -0.7, 1.1;
  for (const double share : {0.0, 1e-3, 1.0}) {
    const Blocks states = {Block(ToParameters(kPose.BoxPlus(share * delta)))};
    EXPECT_LT(testing::WorstJacobianError(PosePriorFactor(kPose, whitening), states, 1e-5), 1e-6);
  }
}

TEST(PosePriorFactor, YawIsAboutTheWorldsVerticalHoweverTheBodyLies) {
  // Turned about W's z by 0.2 rad, and nothing else.
  const Pose turned(ExpSO3({0, 0, 0.2}) * kPose.q(), kPose.p());
  const PosePriorFactor factor(kPose, PoseWhitening(Vector6d::Ones()));
  const Eigen::VectorXd e = testing::Residuals(factor, {Block(ToParameters(turned))});
  EXPECT_NEAR(e[5], 0.2, 1e-12);
  EXPECT_NEAR(e.head<5>().norm(), 0.0, 1e-12);
}

TEST(SpeedBiasPriorFactor, ValueAndJacobian) {
  const SpeedBias expected{{1, 2, 3}, {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}}};
  const SpeedBiasPriorFactor factor(expected, {0.5, 0.01, 0.1});
  EXPECT_EQ(testing::Residuals(factor, {Block(ToParameters(expected))}).norm(), 0.0);
  SpeedBias state = expected;
  state.v_W.y() += 1.0;
  state.bias.gyro.z() -= 0.02;
  state.bias.accel.x() += 0.3;
  const Blocks states = {Block(ToParameters(state))};
  Eigen::Matrix<double, 9, 1> e = Eigen::Matrix<double, 9, 1>::Zero();
  e[1] = 2.0;
  e[5] = -2.0;
  e[6] = 3.0;
  EXPECT_LT((testing::Residuals(factor, states) - e).norm(), 1e-12);
  EXPECT_LT(testing::WorstJacobianError(factor, states), 1e-9);
}

TEST(Priors, RefuseStandardDeviationsOfZero) {
  EXPECT_THROW(PoseWhitening(Vector6d::Zero()), std::logic_error);
  EXPECT_THROW(SpeedBiasPriorFactor({}, {1.0, 0.0, 1.0}), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
