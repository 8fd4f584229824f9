#include "estimator/svin2/loop/fixed_pose_factor.h"

#include <utility>
#include <vector>

#include "sensors_models/base/check.h"
#include "sensors_models/base/pose_manifold.h"

namespace drydock::svin2 {

FixedPoseFactor::FixedPoseFactor(std::unique_ptr<ceres::CostFunction> factor, const Pose& T_WI)
    : factor_(std::move(factor)), T_WI_(ToParameters(T_WI)) {
  const std::vector<int>& sizes = factor_->parameter_block_sizes();
  Check(sizes.size() > 1 && sizes.front() == 7,
        "a factor with a fixed pose needs a pose of 7 first, and other parameters");
  mutable_parameter_block_sizes()->assign(sizes.begin() + 1, sizes.end());
  set_num_residuals(factor_->num_residuals());
}

bool FixedPoseFactor::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  const std::size_t others = parameter_block_sizes().size();
  std::vector<const double*> all = {T_WI_.data()};
  all.insert(all.end(), parameters, parameters + others);
  if (jacobians == nullptr) return factor_->Evaluate(all.data(), residuals, nullptr);
  std::vector<double*> by_all = {nullptr};
  by_all.insert(by_all.end(), jacobians, jacobians + others);
  return factor_->Evaluate(all.data(), residuals, by_all.data());
}

}  // namespace drydock::svin2
