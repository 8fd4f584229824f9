#include "estimator/svin2/factors/linear_prior_factor.h"

#include <utility>

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

int TangentSize(const BlockValues& block) {
  return block.size() == 7 ? 6 : static_cast<int>(block.size());
}

LinearPriorFactor::LinearPriorFactor(LinearPrior prior) : prior_(std::move(prior)) {
  int columns = 0;
  for (const BlockValues& block : prior_.x0) {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(block.size()));
    columns += TangentSize(block);
  }
  Check(columns == prior_.jacobian.cols() && prior_.error.size() == prior_.jacobian.rows(),
        "a linear prior of {} x {} does not fit {} errors and blocks with tangents of {}",
        prior_.jacobian.rows(), prior_.jacobian.cols(), prior_.error.size(), columns);
  set_num_residuals(static_cast<int>(prior_.error.size()));
}

bool LinearPriorFactor::Evaluate(double const* const* parameters, double* residuals,
                                 double** jacobians) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Eigen::VectorXd> error(residuals, num_residuals());
  error = prior_.error;
  int column = 0;
  for (std::size_t k = 0; k < prior_.x0.size(); ++k) {
    const BlockValues& x0 = prior_.x0[k];
    const int size = TangentSize(x0);
    const auto by_change = prior_.jacobian.middleCols(column, size);
    column += size;
    double* jacobian = jacobians == nullptr ? nullptr : jacobians[k];
    if (x0.size() != 7) {
      const Eigen::Map<const Eigen::VectorXd> x(parameters[k], size);
      error += by_change * (x - Eigen::Map<const Eigen::VectorXd>(x0.data(), size));
      if (jacobian != nullptr) {
        Eigen::Map<RowMajor> block(jacobian, num_residuals(), size);
        block = by_change;
      }
      continue;
    }
    const Vector6d change = FromParameters(parameters[k]).BoxMinus(FromParameters(x0.data()));
    error += by_change * change;
    if (jacobian != nullptr) {
      Eigen::Matrix<double, Eigen::Dynamic, 6> by_pose = by_change;
      by_pose.rightCols<3>() *= LeftJacobianInverseSO3(change.tail<3>());
      StorePoseJacobian<Eigen::Dynamic>(parameters[k], by_pose, jacobian);
    }
  }
  return true;
}

}  // namespace drydock::svin2
