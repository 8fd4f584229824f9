#include "estimator/svin2/pose_graph/odometry_chain.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

/// A step that turns, with errors that hang together.
const Pose kStep(FromYawPitchRoll(0.2, -0.1, 0.05), {0.6, 0.1, -0.05});

Matrix6d StepCovariance() {
  Matrix6d root = Matrix6d::Identity();
  root(0, 4) = 0.7;
  root(3, 1) = -0.4;
  const Matrix6d scale = testing::Covariance(0.01, 0.004).cwiseSqrt();
  return scale * root * root.transpose() * scale;
}

OdometryChain Chain(int count) {
  OdometryChain chain;
  for (int k = 0; k < count; ++k) {
    chain.AddNode();
    if (k > 0) chain.Link(kStep, StepCovariance());
  }
  return chain;
}

TEST(OdometryChain, StringsPosesTogether) {
  const OdometryChain chain = Chain(3);
  EXPECT_LT(chain.T_PI(2).BoxMinus(kStep * kStep).norm(), 1e-12);
  EXPECT_EQ(chain.PieceOf(2), chain.PieceOf(0));
}

TEST(OdometryChain, DriftOfOneStepIsThatOfItsEdge) {
  // As seen from the node before, whose orientation in P is that of its pose.
  const OdometryChain chain = Chain(5);
  const Matrix6d at_end = AtPoint(chain.T_PI(4).p(), chain.DriftBetween(3, 4));
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = chain.T_PI(3).R();
  EXPECT_LT((at_end - turn * StepCovariance() * turn.transpose()).norm(), 1e-12);
  EXPECT_EQ(chain.DriftBetween(3, 4), chain.DriftBetween(4, 3));
}

TEST(OdometryChain, DriftIsThatOfManySimulatedChains) {
  constexpr int kFirst = 4, kLast = 16, kChains = 4000;
  const OdometryChain chain = Chain(kLast + 1);
  const Matrix6d root = StepCovariance().llt().matrixL();
  RandomStream random(1, "chains");
  Matrix6d sampled = Matrix6d::Zero();
  for (int n = 0; n < kChains; ++n) {
    Pose T_PI = chain.T_PI(kFirst);
    for (int k = kFirst; k < kLast; ++k) {
      Vector6d noise;
      for (int i = 0; i < 6; ++i) noise[i] = random.Gaussian();
      T_PI = T_PI * kStep.BoxPlus(root * noise);
    }
    const Vector6d error = T_PI.BoxMinus(chain.T_PI(kLast));
    sampled += error * error.transpose() / kChains;
  }
  const Matrix6d predicted = AtPoint(chain.T_PI(kLast).p(), chain.DriftBetween(kFirst, kLast));
  // A sample of 4000 knows variances to 2.2 %.
  EXPECT_LT((sampled - predicted).norm(), 0.08 * predicted.norm());
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(sampled(i, i), predicted(i, i), 0.1 * predicted(i, i)) << i;
}

TEST(OdometryChain, TransportedMotionMovesThePointsTheSame) {
  const Pose T_QP(FromYawPitchRoll(1.0, 0.3, -0.2), {10, -4, 2});
  const Eigen::Vector3d p_P(3, 1, -2);
  const Matrix6d in_P = StepCovariance();
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = T_QP.R();
  const Matrix6d expected = turn * AtPoint(p_P, in_P) * turn.transpose();
  EXPECT_LT((AtPoint(T_QP * p_P, Transported(T_QP, in_P)) - expected).norm(), 1e-12);
}

TEST(OdometryChain, ANodeWithoutALinkStartsAPiece) {
  OdometryChain chain = Chain(3);
  chain.AddNode();
  chain.AddNode();
  chain.Link(kStep, StepCovariance());
  EXPECT_NE(chain.PieceOf(3), chain.PieceOf(2));
  EXPECT_EQ(chain.PieceOf(4), chain.PieceOf(3));
  EXPECT_LT(chain.T_PI(4).BoxMinus(kStep).norm(), 1e-12);
  EXPECT_THROW(Chain(1).Link(kStep, StepCovariance()), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
