// A factor of a pose that is known.
#pragma once

#include <array>
#include <memory>

#include <ceres/cost_function.h>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// Parameters and residuals: those of `factor` without its first parameter, the pose (7), which
/// stays at `T_WI`. Cheaper and more exact than a prior that holds the pose.
class FixedPoseFactor final : public ceres::CostFunction {
 public:
  FixedPoseFactor(std::unique_ptr<ceres::CostFunction> factor, const Pose& T_WI);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::unique_ptr<ceres::CostFunction> factor_;
  std::array<double, 7> T_WI_;
};

}  // namespace drydock::svin2
