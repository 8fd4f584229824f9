#include "estimator/svin2/loop/loop_edge.h"

#include <gtest/gtest.h>

#include "tests/support/numeric.h"

namespace drydock::svin2 {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

const Pose kLoop(FromYawPitchRoll(0.4, -0.1, 0.2), {0.5, -1.2, 0.3});

Matrix6d Covariance() {
  Matrix6d root = Matrix6d::Identity();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) root(i, j) += 0.1 * i - 0.07 * j * i + 0.02 * j;
  return root * root.transpose();
}

// The covariance of `tangent` of a pose that is moved by [dp, da] of `covariance` on the left.
template <typename Tangent>
Matrix6d Numeric(Tangent tangent, const Pose& pose, const Matrix6d& covariance) {
  Matrix6d by_delta;
  for (int axis = 0; axis < 6; ++axis) {
    by_delta.col(axis) = drydock::testing::NumericDerivative(
        [&](double by) -> Vector6d { return tangent(pose.BoxPlus(by * Vector6d::Unit(axis))); },
        0.0, 1e-5);
  }
  return by_delta * covariance * by_delta.transpose();
}

TEST(LoopEdge, CovarianceOfTheInverse) {
  const Matrix6d expected = Numeric(
      [](const Pose& T) { return T.Inverse().BoxMinus(kLoop.Inverse()); }, kLoop, Covariance());
  EXPECT_LT((CovarianceOfInverse(kLoop, Covariance()) - expected).norm(), 1e-7);
}

// By the numeric derivatives of T_then_before by both perturbations.
TEST(LoopEdge, AtTheKeyframeBefore) {
  const Pose T_before_now(FromYawPitchRoll(-0.3, 0.2, 0.1), {0.6, 0.1, -0.2});
  const Matrix6d link = 0.3 * Covariance() + Matrix6d::Identity();
  const LoopEdge found = AtKeyframeBefore({kLoop, Covariance()}, {T_before_now, link});
  const Pose expected = kLoop * T_before_now.Inverse();
  EXPECT_LT(found.T_then_now.BoxMinus(expected).norm(), 1e-12);

  const Matrix6d by_loop =
      Numeric([&](const Pose& T) { return (T * T_before_now.Inverse()).BoxMinus(expected); }, kLoop,
              Covariance());
  const Matrix6d by_link = Numeric(
      [&](const Pose& T) { return (kLoop * T.Inverse()).BoxMinus(expected); }, T_before_now, link);
  EXPECT_LT((found.covariance - by_loop - by_link).norm(), 1e-7);
}

// Odometry that has drifted since `then` by one motion is brought back by that motion.
TEST(LoopEdge, DriftBringsOdometryBack) {
  const Pose T_graph_then(FromYawPitchRoll(1.0, 0.1, 0.0), {3, 4, -1});
  const Pose drift(FromYawPitchRoll(0.05, 0.0, 0.0), {0.3, -0.2, 0.01});
  const Pose T_W_now = drift.Inverse() * (T_graph_then * kLoop);
  const Pose found = Drift(T_graph_then, kLoop, T_W_now);
  EXPECT_LT(found.BoxMinus(drift).norm(), 1e-12);
}

}  // namespace
}  // namespace drydock::svin2
