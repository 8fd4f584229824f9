#include "estimator/svin2/factors/relative_pose_factor.h"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/prior_factors.h"
#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;
using testing::Block;
using testing::Blocks;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

const Pose kT_i(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});
const Pose kT_ij(FromYawPitchRoll(-1.1, 0.4, 0.1), {0.5, -0.2, 0.3});

/// Full, of no particular shape.
Matrix6d Covariance() {
  Matrix6d root = Matrix6d::Identity();
  root(0, 5) = 0.3;
  root(4, 1) = -0.2;
  root(2, 2) = 0.5;
  return 0.04 * root * root.transpose();
}

Blocks States(const Pose& T_i, const Pose& T_j) {
  return {Block(ToParameters(T_i)), Block(ToParameters(T_j))};
}

TEST(RelativePoseFactor, ValueByHand) {
  // i looks along W's y; j is 2 m before it, turned left by another 0.1 rad. Measured: 1.9 m ahead,
  // 0.2 m to the left, without a turn.
  const Pose T_i(FromYawPitchRoll(std::numbers::pi / 2, 0, 0), {5, 1, 0});
  const Pose T_j(FromYawPitchRoll(std::numbers::pi / 2 + 0.1, 0, 0), {5, 3, 0});
  Vector6d sigmas;
  sigmas << 0.1, 0.2, 0.3, 0.01, 0.02, 0.05;
  const RelativePoseFactor factor(Pose(Eigen::Quaterniond::Identity(), {1.9, 0.2, 0}),
                                  PoseWhitening(sigmas));
  Vector6d expected;
  expected << 1.0, -1.0, 0.0, 0.0, 0.0, 2.0;
  EXPECT_LT((testing::Residuals(factor, States(T_i, T_j)) - expected).norm(), 1e-12);
}

TEST(RelativePoseFactor, VanishesAtTruthWhereverThePairLies) {
  const RelativePoseFactor factor(kT_ij, WhiteningOf(Covariance()));
  const Pose elsewhere(FromYawPitchRoll(2.0, 0.5, -0.4), {-40, 70, 9});
  for (const Pose& T_i : {kT_i, elsewhere * kT_i}) {
    EXPECT_LT(testing::Residuals(factor, States(T_i, T_i * kT_ij)).norm(), 1e-9);
  }
}

TEST(RelativePoseFactor, VanishesWhateverTheQuaternionsSigns) {
  const RelativePoseFactor factor(kT_ij, WhiteningOf(Covariance()));
  Blocks states = States(kT_i, kT_i * kT_ij);
  for (std::size_t k = 3; k < 7; ++k) states[1][k] = -states[1][k];
  EXPECT_LT(testing::Residuals(factor, states).norm(), 1e-9);
}

TEST(RelativePoseFactor, ItsErrorIsTheNoiseOfTheMeasurement) {
  Vector6d noise;
  noise << 0.01, -0.02, 0.03, 0.001, 0.002, -0.003;
  const RelativePoseFactor factor(kT_ij.BoxPlus(noise), Matrix6d::Identity());
  EXPECT_LT((testing::Residuals(factor, States(kT_i, kT_i * kT_ij)) + noise).norm(), 1e-4);
}

TEST(RelativePoseFactor, JacobianMatchesDifferencesAlsoFarOff) {
  Vector6d delta;
  delta << 3.0, -20.0, 7.0, 0.9, -1.2, 1.9;
  const RelativePoseFactor factor(kT_ij, WhiteningOf(Covariance()));
  for (const double share : {0.0, 1e-5, 1e-3, 0.1, 1.0, 1.25}) {
    const Blocks states = States(kT_i, (kT_i * kT_ij).BoxPlus(share * delta));
    EXPECT_LT(testing::WorstJacobianError(factor, states, 1e-5), 1e-6) << share;
  }
}

TEST(RelativePoseFactor, AlmostHalfATurnOffHasDerivatives) {
  const RelativePoseFactor factor(kT_ij, WhiteningOf(Covariance()));
  const Vector3d axis = Vector3d(1, -2, 0.5).normalized();
  for (const double short_of : {1e-2, 1e-3}) {
    Vector6d delta = Vector6d::Zero();
    delta.tail<3>() = (std::numbers::pi - short_of) * axis;
    const Blocks states = States(kT_i, (kT_i * kT_ij).BoxPlus(delta));
    EXPECT_LT(testing::WorstJacobianError(factor, states, 1e-6), 1e-6) << short_of;
  }
}

TEST(RelativePoseFactor, HalfATurnOffIsFinite) {
  const RelativePoseFactor factor(kT_ij, Matrix6d::Identity());
  for (int axis = 0; axis < 3; ++axis) {
    Vector6d delta = Vector6d::Zero();
    delta[3 + axis] = std::numbers::pi;
    const Blocks states = States(kT_i, kT_i * kT_ij.BoxPlus(delta));
    EXPECT_NEAR(testing::Residuals(factor, states).norm(), std::numbers::pi, 1e-9);
    for (const auto& jacobian : testing::TangentJacobians(factor, states)) {
      EXPECT_TRUE(jacobian.allFinite());
      EXPECT_LT(jacobian.norm(), 100.0);
    }
  }
}

TEST(WhiteningOf, MakesWhite) {
  const Matrix6d whitening = WhiteningOf(Covariance());
  EXPECT_TRUE((whitening * Covariance() * whitening.transpose()).isIdentity(1e-12));
  EXPECT_THROW(WhiteningOf(Matrix6d::Zero()), std::logic_error);
  EXPECT_THROW(WhiteningOf(Matrix6d::Constant(std::nan(""))), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
