// Marginalisation where everything is linear, so that dense algebra says what must come out.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "estimator/svin2/factors/marginalisation.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

/// e = A x + c over Euclidean blocks.
class LinearFactor final : public ceres::CostFunction {
 public:
  LinearFactor(Eigen::MatrixXd A, Eigen::VectorXd c, const std::vector<int>& sizes)
      : A_(std::move(A)), c_(std::move(c)) {
    set_num_residuals(static_cast<int>(c_.size()));
    mutable_parameter_block_sizes()->assign(sizes.begin(), sizes.end());
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    Eigen::VectorXd e = c_;
    int column = 0;
    for (std::size_t k = 0; k < parameter_block_sizes().size(); ++k) {
      const int size = parameter_block_sizes()[k];
      e += A_.middleCols(column, size) * Eigen::Map<const Eigen::VectorXd>(parameters[k], size);
      if (jacobians != nullptr && jacobians[k] != nullptr) {
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            jacobians[k], num_residuals(), size) = A_.middleCols(column, size);
      }
      column += size;
    }
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = e;
    return true;
  }

 private:
  Eigen::MatrixXd A_;
  Eigen::VectorXd c_;
};

Eigen::MatrixXd Random(RandomStream& random, int rows, int columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.Gaussian(); });
}

/// Five blocks in a chain and two terms that reach further, with the same as one dense system.
struct System {
  std::vector<BlockValues> blocks;
  std::vector<std::unique_ptr<LinearFactor>> factors;
  std::vector<MarginalTerm> terms;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(0, 17);
  Eigen::VectorXd c;
  std::vector<int> offsets = {0, 3, 5, 9, 12};

  explicit System(double scale_of_second = 1.0) {
    RandomStream random(1, "marginalisation");
    for (const int size : {3, 2, 4, 3, 5}) {
      const Eigen::VectorXd x = Random(random, size, 1);
      blocks.emplace_back(x.begin(), x.end());
    }
    for (const std::vector<std::size_t>& of : std::vector<std::vector<std::size_t>>{
             {0}, {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4}, {4, 0}, {1, 3, 2}}) {
      Add(random, of, scale_of_second);
    }
  }

  void Add(RandomStream& random, const std::vector<std::size_t>& of, double scale_of_second) {
    std::vector<int> sizes;
    int columns = 0;
    for (const std::size_t k : of) {
      sizes.push_back(static_cast<int>(blocks[k].size()));
      columns += sizes.back();
    }
    Eigen::MatrixXd J = Random(random, 6, columns);
    int column = 0;
    for (std::size_t k = 0; k < of.size(); ++k) {
      if (of[k] == 1) J.middleCols(column, 2) *= scale_of_second;
      column += sizes[k];
    }
    const Eigen::VectorXd e = Random(random, 6, 1);
    A.conservativeResizeLike(Eigen::MatrixXd::Zero(A.rows() + 6, 17));
    c.conservativeResize(A.rows());
    c.tail(6) = e;
    column = 0;
    for (std::size_t k = 0; k < of.size(); ++k) {
      A.block(A.rows() - 6, offsets[of[k]], 6, sizes[k]) = J.middleCols(column, sizes[k]);
      column += sizes[k];
    }
    factors.push_back(std::make_unique<LinearFactor>(J, e, sizes));
    terms.push_back({factors.back().get(), nullptr, of});
  }

  /// The least-squares solution of all blocks.
  Eigen::VectorXd Solution() const { return (A.transpose() * A).ldlt().solve(-A.transpose() * c); }
};

/// Least-squares solution of a prior over Euclidean blocks.
Eigen::VectorXd Minimum(const LinearPrior& prior) {
  std::vector<double> x0;
  for (const BlockValues& block : prior.x0) x0.insert(x0.end(), block.begin(), block.end());
  const Eigen::Map<const Eigen::VectorXd> start(x0.data(), static_cast<int>(x0.size()));
  const Eigen::MatrixXd& J = prior.jacobian;
  return start + (J.transpose() * J).ldlt().solve(-J.transpose() * prior.error);
}

TEST(MarginalisationLinear, GivesTheBatchSolutionAndCovariance) {
  const System system;
  const std::vector<std::size_t> kept = {3, 1};
  const LinearPrior prior = Marginalise(system.blocks, system.terms, kept);
  Eigen::VectorXd expected(5);
  const Eigen::VectorXd solution = system.Solution();
  expected << solution.segment<3>(9), solution.segment<2>(3);
  EXPECT_LT((Minimum(prior) - expected).norm(), 1e-12);

  const Eigen::MatrixXd covariance = (system.A.transpose() * system.A).inverse();
  const Eigen::MatrixXd of_prior = (prior.jacobian.transpose() * prior.jacobian).inverse();
  EXPECT_LT((of_prior.topLeftCorner<3, 3>() - covariance.block<3, 3>(9, 9)).norm(), 1e-12);
  EXPECT_LT((of_prior.topRightCorner<3, 2>() - covariance.block<3, 2>(9, 3)).norm(), 1e-12);
}

TEST(MarginalisationLinear, UnitsDoNotMatter) {
  // One block in units a million times smaller, as biases are beside positions.
  const System system(1e6);
  const LinearPrior prior =
      Marginalise(system.blocks, system.terms, std::vector<std::size_t>{0, 4});
  Eigen::VectorXd expected(8);
  const Eigen::VectorXd solution = system.Solution();
  expected << solution.head<3>(), solution.tail<5>();
  EXPECT_LT((Minimum(prior) - expected).norm(), 1e-9);
}

TEST(MarginalisationLinear, InTwoStepsAsInOne) {
  const System system;
  // First block 0 with what touches it goes into a prior over 1 and 4, then 1 goes too.
  std::vector<MarginalTerm> first, second;
  for (const MarginalTerm& term : system.terms) {
    const bool touches = std::find(term.blocks.begin(), term.blocks.end(), 0u) != term.blocks.end();
    (touches ? first : second).push_back(term);
  }
  const LinearPriorFactor between(
      Marginalise(system.blocks, first, std::vector<std::size_t>{1, 4}));
  second.push_back({&between, nullptr, {1, 4}});
  const std::vector<BlockValues> rest(system.blocks.begin() + 1, system.blocks.end());
  for (MarginalTerm& term : second)
    for (std::size_t& k : term.blocks) --k;
  const LinearPrior twice = Marginalise(rest, second, std::vector<std::size_t>{1, 2, 3});
  const LinearPrior once =
      Marginalise(system.blocks, system.terms, std::vector<std::size_t>{2, 3, 4});
  EXPECT_LT((Minimum(twice) - Minimum(once)).norm(), 1e-11);
  EXPECT_LT(
      (twice.jacobian.transpose() * twice.jacobian - once.jacobian.transpose() * once.jacobian)
          .norm(),
      1e-11);
}

TEST(MarginalisationLinear, WhatIsUnknownStaysUnknown) {
  // Only the difference of two blocks is measured, and of a third nothing: eliminating one leaves
  // nothing about the other.
  Eigen::MatrixXd A(2, 4);
  A << 1, 0, -1, 0, 0, 1, 0, -1;
  const LinearFactor difference(A, Eigen::Vector2d(1.0, 2.0), {2, 2});
  const std::vector<BlockValues> blocks = {{0, 0}, {0, 0}, {5, 5, 5}};
  const std::vector<MarginalTerm> terms = {{&difference, nullptr, {0, 1}}};
  const LinearPrior prior = Marginalise(blocks, terms, std::vector<std::size_t>{1});
  EXPECT_EQ(prior.jacobian.rows(), 1);
  EXPECT_EQ(prior.jacobian.norm(), 0.0);
  EXPECT_EQ(prior.error.norm(), 0.0);
  // Kept together with its partner, the difference is known: two directions of seven.
  const LinearPrior both = Marginalise(blocks, terms, std::vector<std::size_t>{0, 1, 2});
  EXPECT_EQ(both.jacobian.rows(), 2);
  EXPECT_NEAR(both.error.squaredNorm(), 5.0, 1e-12);
}

// Two places are 0.1 mm sure of each other and 30 m of the origin: eleven orders of magnitude apart
// in information, and both kept.
TEST(MarginalisationLinear, KeepsWhatIsHardlyKnownBesideWhatIsKnownWell) {
  constexpr double kFar = 30.0, kNear = 1e-4;
  const LinearFactor absolute(Eigen::MatrixXd::Constant(1, 1, 1.0 / kFar), Eigen::VectorXd::Zero(1),
                              {1});
  const LinearFactor step(Eigen::RowVector2d(-1.0, 1.0) / kNear, Eigen::VectorXd::Zero(1), {1, 1});
  const std::vector<BlockValues> blocks = {{0}, {0}, {0}};
  const std::vector<MarginalTerm> terms = {
      {&absolute, nullptr, {0}}, {&step, nullptr, {0, 1}}, {&step, nullptr, {1, 2}}};
  const LinearPrior prior = Marginalise(blocks, terms, std::vector<std::size_t>{1, 2});
  ASSERT_EQ(prior.jacobian.rows(), 2);
  const Eigen::Matrix2d covariance = (prior.jacobian.transpose() * prior.jacobian).inverse();
  EXPECT_NEAR(covariance(1, 1) / (kFar * kFar), 1.0, 1e-3);
}

TEST(MarginalisationLinear, ARobustLossWeighsByItsSlope) {
  // An error of 3 under Cauchy(1): slope 1 / (1 + 9), so information a tenth.
  const LinearFactor factor(Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXd::Constant(1, 3.0),
                            {1});
  const ceres::CauchyLoss loss(1.0);
  const std::vector<BlockValues> blocks = {{0.0}};
  const std::vector<MarginalTerm> terms = {{&factor, &loss, {0}}};
  const LinearPrior prior = Marginalise(blocks, terms, std::vector<std::size_t>{0});
  EXPECT_NEAR(prior.jacobian(0, 0) * prior.jacobian(0, 0), 0.1, 1e-15);
  EXPECT_NEAR(prior.jacobian(0, 0) * prior.error(0), 0.3, 1e-15);
}

TEST(MarginalisationLinear, LeavesOutATermThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LinearFactor bad(Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXd::Constant(1, nan), {1});
  const LinearFactor good(Eigen::MatrixXd::Identity(1, 1), Eigen::VectorXd::Constant(1, 2.0), {1});
  const std::vector<BlockValues> blocks = {{0.0}};
  const std::vector<MarginalTerm> terms = {{&bad, nullptr, {0}}, {&good, nullptr, {0}}};
  const LinearPrior prior = Marginalise(blocks, terms, std::vector<std::size_t>{0});
  EXPECT_NEAR(Minimum(prior)[0], -2.0, 1e-15);
}

TEST(MarginalisationLinear, MustKeepABlock) {
  EXPECT_THROW(Marginalise({}, {}, {}), std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
