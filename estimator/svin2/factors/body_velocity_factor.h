// How fast a body swims that nothing else is known of.
#pragma once

#include <Eigen/Core>

#include <ceres/sized_cost_function.h>

namespace drydock::svin2 {

/// Parameters: pose T_WI (7), speed and biases (9). Residual, v_I being what is expected of the
/// velocity in the body's frame:
///   e = (R' v_W - v_I) / sigma
/// Tangents: [dp, da], exp(da) q; [dv, db_g, db_a]:
///   de/dp = 0,   de/da = R' [v_W]x,   de/dv = R'   (each over sigma)
class BodyVelocityFactor final : public ceres::SizedCostFunction<3, 7, 9> {
 public:
  /// `sigma`: standard deviation of each component [m/s], > 0.
  BodyVelocityFactor(const Eigen::Vector3d& v_I, double sigma);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d v_I_;
  double sigma_;
};

}  // namespace drydock::svin2
