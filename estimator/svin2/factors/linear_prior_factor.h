// What measurements that are gone have said about the states that stay.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <ceres/cost_function.h>

namespace drydock::svin2 {

/// Parameters of one block. A block of 7 is a pose, on PoseManifold; all others are Euclidean.
using BlockValues = std::vector<double>;

/// Dimension of the block's tangent space.
int TangentSize(const BlockValues& block);

/// The quadratic cost 1/2 |error + jacobian (x - x0)|^2, with x - x0 in the tangent spaces of the
/// blocks at x0, one under the other: for poses [p - p0; Log(q q0^-1)] (PoseManifold's Minus).
struct LinearPrior {
  std::vector<BlockValues> x0;  ///< Where it was linearised; stays the same for good.
  Eigen::MatrixXd jacobian;     ///< As many rows as directions are known, at least 1.
  Eigen::VectorXd error;
};

/// A LinearPrior in the optimisation. Parameters: the prior's blocks, in its order.
class LinearPriorFactor final : public ceres::CostFunction {
 public:
  explicit LinearPriorFactor(LinearPrior prior);

  const LinearPrior& prior() const { return prior_; }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  LinearPrior prior_;
};

}  // namespace drydock::svin2
