#include "estimator/svin2/graph/factor_graph.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <ceres/sized_cost_function.h>
#include <gtest/gtest.h>

#include "estimator/svin2/factors/prior_factors.h"

namespace drydock::svin2 {
namespace {

using Scalar = std::array<double, 1>;

/// b - a was measured, with unit standard deviation.
class Difference final : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  explicit Difference(double measured) : measured_(measured) {}

  bool Evaluate(double const* const* x, double* residual, double** jacobians) const override {
    residual[0] = x[1][0] - x[0][0] - measured_;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) jacobians[0][0] = -1.0;
    if (jacobians[1] != nullptr) jacobians[1][0] = 1.0;
    return true;
  }

 private:
  double measured_;
};

/// x was measured with unit standard deviation; cannot be evaluated where x is above 1000.
class Value final : public ceres::SizedCostFunction<1, 1> {
 public:
  explicit Value(double measured) : measured_(measured) {}

  bool Evaluate(double const* const* x, double* residual, double** jacobians) const override {
    residual[0] = x[0][0] - measured_;
    if (jacobians != nullptr && jacobians[0] != nullptr) jacobians[0][0] = 1.0;
    return x[0][0] <= 1000.0;
  }

 private:
  double measured_;
};

class FactorGraphTest : public ::testing::Test {
 protected:
  BlockId Add(double value) { return graph_.AddBlock(Scalar{value}); }
  double At(BlockId block) const { return graph_.Values(block)[0]; }
  void Measure(BlockId a, BlockId b, double difference) {
    graph_.AddFactor(std::make_unique<Difference>(difference), {a, b});
  }

  FactorGraph graph_;
};

TEST_F(FactorGraphTest, OptimisesToTheLeastCost) {
  // 0 <- a, a + 1 <- b, 3 <- b: the loop misses by 2 - 1 = 1 over three factors, so each takes 2/3.
  const BlockId a = Add(7.0), b = Add(-7.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  Measure(a, b, 1.0);
  graph_.AddFactor(std::make_unique<Value>(3.0), {b});
  const SolverReport report = graph_.Optimise({50, std::nullopt});
  EXPECT_TRUE(report.usable);
  EXPECT_LT(report.final_cost, report.initial_cost);
  EXPECT_NEAR(At(a), 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(At(b), 7.0 / 3.0, 1e-6);
}

TEST_F(FactorGraphTest, MarginalisedBlocksAreRemembered) {
  // A chain of three steps; the whole is linear, so that taking blocks out changes nothing.
  const BlockId a = Add(0.1), b = Add(0.9), c = Add(2.2), d = Add(3.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  Measure(a, b, 1.0);
  Measure(b, c, 1.0);
  Measure(c, d, 1.0);
  graph_.Marginalise(std::array{a});
  graph_.Marginalise(std::array{b});
  EXPECT_EQ(graph_.num_blocks(), 2U);
  EXPECT_TRUE(graph_.IsInPrior(c));
  EXPECT_FALSE(graph_.IsInPrior(d));
  // Of a chain of unit steps from a unit prior: c has variance 3, d has 4, both in one
  // optimisation with d measured at 7: it gets 3 + 4 * 4 / 5.
  EXPECT_NEAR((*graph_.CovarianceOf(c))(0, 0), 3.0, 1e-9);
  EXPECT_NEAR((*graph_.CovarianceOf(d))(0, 0), 4.0, 1e-9);
  graph_.AddFactor(std::make_unique<Value>(7.0), {d});
  graph_.Optimise({50, std::nullopt});
  // Ceres stops where the cost falls by less than a millionth.
  EXPECT_NEAR(At(d), 3.0 + 4.0 * 4.0 / 5.0, 2e-3);
  EXPECT_NEAR(At(c), 2.0 + 3.0 * 4.0 / 5.0, 2e-3);
}

// A chain of unit steps from a unit prior: b has variance 2, c 3, and they share b's.
TEST_F(FactorGraphTest, CovarianceOfTwoBlocksIsTheirJointOne) {
  const BlockId a = Add(0.0), b = Add(1.0), c = Add(2.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  Measure(a, b, 1.0);
  Measure(b, c, 1.0);
  const Eigen::MatrixXd joint = graph_.CovarianceOf(std::array{b, c}).value();
  EXPECT_LT((joint - Eigen::Matrix2d{{2.0, 2.0}, {2.0, 3.0}}).norm(), 1e-9);
  const Eigen::MatrixXd swapped = graph_.CovarianceOf(std::array{c, b}).value();
  EXPECT_LT((swapped - Eigen::Matrix2d{{3.0, 2.0}, {2.0, 2.0}}).norm(), 1e-9);
}

TEST_F(FactorGraphTest, TheLastBlockMarginalisedLeavesNoPrior) {
  const BlockId a = Add(1.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  graph_.Marginalise(std::array{a});
  EXPECT_EQ(graph_.num_blocks(), 0U);
  EXPECT_EQ(graph_.num_factors(), 0U);
}

TEST_F(FactorGraphTest, RemovedBlocksAreForgotten) {
  const BlockId a = Add(0.0), b = Add(5.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  Measure(a, b, 1.0);
  graph_.RemoveBlock(b);
  EXPECT_EQ(graph_.num_factors(), 1U);
  EXPECT_EQ(graph_.FactorsOf(a).size(), 1U);
  EXPECT_NEAR((*graph_.CovarianceOf(a))(0, 0), 1.0, 1e-12);
}

TEST_F(FactorGraphTest, APriorCannotBeForgotten) {
  const BlockId a = Add(0.0), b = Add(1.0);
  Measure(a, b, 1.0);
  graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  graph_.Marginalise(std::array{a});
  EXPECT_THROW(graph_.RemoveBlock(b), std::logic_error);
}

TEST_F(FactorGraphTest, RobustLossHoldsAnOutlierBack) {
  const BlockId plain = Add(0.0), robust = Add(0.0);
  for (int k = 0; k < 9; ++k) {
    graph_.AddFactor(std::make_unique<Value>(0.0), {plain});
    graph_.AddFactor(std::make_unique<Value>(0.0), {robust}, 1.0);
  }
  graph_.AddFactor(std::make_unique<Value>(100.0), {plain});
  const FactorId outlier = graph_.AddFactor(std::make_unique<Value>(100.0), {robust}, 1.0);
  graph_.Optimise({50, std::nullopt});
  EXPECT_NEAR(At(plain), 10.0, 2e-3);
  // Cauchy's pull of a far outlier is 1 / distance: 9 x = 1 / 100.
  EXPECT_NEAR(At(robust), 1.0 / 900.0, 1e-5);
  EXPECT_NEAR(graph_.ChiSquare(outlier), 1e4, 1.0);
}

TEST_F(FactorGraphTest, WhatCannotBeEvaluatedLeavesTheStatesAlone) {
  const BlockId a = Add(2000.0);
  const FactorId factor = graph_.AddFactor(std::make_unique<Value>(0.0), {a});
  const SolverReport report = graph_.Optimise({});
  EXPECT_FALSE(report.usable);
  EXPECT_EQ(At(a), 2000.0);
  EXPECT_EQ(graph_.ChiSquare(factor), std::numeric_limits<double>::infinity());
}

TEST_F(FactorGraphTest, WhatIsNotDeterminedHasNoCovariance) {
  const BlockId a = Add(0.0), b = Add(1.0);
  Measure(a, b, 1.0);
  EXPECT_FALSE(graph_.CovarianceOf(a).has_value());
}

TEST_F(FactorGraphTest, PosesMoveOnTheirManifold) {
  const Pose measured(FromYawPitchRoll(0.5, -0.2, 0.1), {1, 2, 3});
  const BlockId pose = graph_.AddPose(Pose::Identity());
  const auto whitening = PoseWhitening(Vector6d::Constant(0.1));
  graph_.AddFactor(std::make_unique<PosePriorFactor>(measured, whitening), {pose});
  graph_.Optimise({50, std::nullopt});
  EXPECT_LT(graph_.PoseOf(pose).BoxMinus(measured).norm(), 1e-6);
  const auto covariance = graph_.CovarianceOf(pose);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_TRUE(covariance->isApprox(0.01 * Eigen::MatrixXd::Identity(6, 6), 1e-6));
}

TEST_F(FactorGraphTest, OutOfTimeTheStatesStayWhereTheyAre) {
  const BlockId a = Add(3.0);
  graph_.AddFactor(std::make_unique<Value>(7.0), {a});
  EXPECT_TRUE(graph_.Optimise({5, 1e-9}).usable);
  EXPECT_EQ(At(a), 3.0);
  EXPECT_TRUE(graph_.Optimise({5, 100.0}).usable);
  EXPECT_NEAR(At(a), 7.0, 1e-3);
}

}  // namespace
}  // namespace drydock::svin2
