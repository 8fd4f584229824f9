#include "estimator/svin2/factors/linear_prior_factor.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/estimator/svin2/factors/factor_check.h"

namespace drydock::svin2 {
namespace {

using testing::Block;
using testing::Blocks;

const Pose kPose(FromYawPitchRoll(0.7, -0.2, 0.3), {1, 2, -3});

/// Over a pose and a landmark: two rows of numbers that are all different.
LinearPrior Prior() {
  LinearPrior prior;
  prior.x0 = {Block(ToParameters(kPose)), {4.0, 5.0, 6.0}};
  prior.jacobian.resize(2, 9);
  for (int k = 0; k < 9; ++k) prior.jacobian.col(k) << 1.0 + k, 0.5 * k * k - 3.0;
  prior.error = Eigen::Vector2d(0.1, -0.2);
  return prior;
}

TEST(LinearPriorFactor, ValueByHand) {
  const LinearPriorFactor factor(Prior());
  EXPECT_EQ(testing::Residuals(factor, Prior().x0), Prior().error);
  Vector6d delta = Vector6d::Zero();
  delta[1] = 0.1;   // Second column: (2, -2.5).
  delta[3] = -0.2;  // Fourth: (4, 1.5).
  const Blocks moved = {Block(ToParameters(kPose.BoxPlus(delta))), {4.0, 5.0, 6.01}};
  // Ninth: (9, 29), by 0.01.
  const Eigen::Vector2d expected(0.1 + 0.2 - 0.8 + 0.09, -0.2 - 0.25 - 0.3 + 0.29);
  EXPECT_LT((testing::Residuals(factor, moved) - expected).norm(), 1e-12);
}

TEST(LinearPriorFactor, JacobianMatchesDifferencesFarFromItsPoint) {
  Vector6d delta;
  delta << 0.1, -0.1, 0.1, 0.5, -0.7, 1.1;
  for (const double share : {0.0, 1e-3, 1.0}) {
    const Blocks states = {Block(ToParameters(kPose.BoxPlus(share * delta))), {4.5, 5.0, 6.0}};
    EXPECT_LT(testing::WorstJacobianError(LinearPriorFactor(Prior()), states, 1e-5), 1e-6);
  }
}

TEST(LinearPriorFactor, RefusesSizesThatDoNotFit) {
  LinearPrior prior = Prior();
  prior.x0.pop_back();
  EXPECT_THROW(LinearPriorFactor{prior}, std::logic_error);
}

}  // namespace
}  // namespace drydock::svin2
