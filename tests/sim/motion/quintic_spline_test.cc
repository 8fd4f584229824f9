#include "sim/motion/quintic_spline.h"

#include <gtest/gtest.h>

#include "tests/support/numeric.h"

namespace drydock::sim {
namespace {

using testing::NumericDerivative;

const std::vector<double> kTimes = {0.0, 1.0, 2.5, 3.0, 5.0, 5.8, 7.0};

Eigen::MatrixXd Points() {
  Eigen::MatrixXd points(2, 7);
  points << 0, 1, 3, 2, 4, 4.5, 3,  //
      0, -1, 0.5, 2, 1.5, 0, 0.2;
  return points;
}

TEST(QuinticSpline, PassesThroughItsPoints) {
  const QuinticSpline spline(kTimes, Points());
  for (std::size_t i = 0; i < kTimes.size(); ++i) {
    EXPECT_LT((spline.Evaluate(kTimes[i]) - Points().col(static_cast<Eigen::Index>(i))).norm(),
              1e-12);
  }
}

TEST(QuinticSpline, StartsAndEndsAtRest) {
  const QuinticSpline spline(kTimes, Points());
  for (const double t : {0.0, 7.0}) {
    EXPECT_LT(spline.Evaluate(t, 1).norm(), 1e-12);
    EXPECT_LT(spline.Evaluate(t, 2).norm(), 1e-11);
  }
}

TEST(QuinticSpline, DerivativesMatchNumeric) {
  const QuinticSpline spline(kTimes, Points());
  for (double t = 0.1; t < 6.95; t += 0.173) {
    for (int order = 1; order <= 4; ++order) {
      const Eigen::VectorXd numeric =
          NumericDerivative([&](double x) { return spline.Evaluate(x, order - 1); }, t, 1e-5);
      EXPECT_LT((spline.Evaluate(t, order) - numeric).norm(), 1e-4 * (1.0 + numeric.norm()))
          << "order " << order << " at " << t;
    }
  }
}

TEST(QuinticSpline, FourDerivativesAreContinuousAtTheKnots) {
  const QuinticSpline spline(kTimes, Points());
  for (std::size_t i = 1; i + 1 < kTimes.size(); ++i) {
    for (int order = 0; order <= 4; ++order) {
      constexpr double kStep = 1e-9;
      const Eigen::VectorXd before = spline.Evaluate(kTimes[i] - kStep, order);
      const Eigen::VectorXd after = spline.Evaluate(kTimes[i] + kStep, order);
      EXPECT_LT((before - after).norm(), 1e-5 * (1.0 + after.norm()))
          << "order " << order << " at " << kTimes[i];
    }
  }
}

TEST(QuinticSpline, TwoPointsAreEnough) {
  Eigen::MatrixXd points(1, 2);
  points << 1.0, 3.0;
  const QuinticSpline spline({0.0, 2.0}, points);
  EXPECT_NEAR(spline.Evaluate(1.0)[0], 2.0, 1e-12);  // By symmetry.
  EXPECT_NEAR(spline.Evaluate(9.0)[0], 3.0, 1e-12);  // Clamped.
}

TEST(QuinticSpline, TimesMustIncrease) {
  EXPECT_THROW(QuinticSpline({0.0, 1.0, 1.0}, Eigen::MatrixXd::Zero(1, 3)), std::logic_error);
  EXPECT_THROW(QuinticSpline({0.0}, Eigen::MatrixXd::Zero(1, 1)), std::logic_error);
}

}  // namespace
}  // namespace drydock::sim
