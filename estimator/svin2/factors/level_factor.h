// Height and tilt, which gravity and the pressure sensor hold wherever the body has drifted to.
#pragma once

#include <ceres/sized_cost_function.h>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// Parameters: pose T_WI (7). Residual, against odometry's pose (p_0, R_0) and with e_z up:
///   e_z = (p_z - p_0,z) / sigma_z
///   e_t = (x and y of u) / sigma_tilt,   u = R_WI R_0^T e_z   [rad, for small tilts]
/// u is where the body now has up, if odometry had it right; turning about the vertical and moving
/// on the level change nothing. Tangent: [dp, da], exp(da) q, in W.
class LevelFactor final : public ceres::SizedCostFunction<3, 7> {
 public:
  /// [m, rad], both > 0.
  LevelFactor(const Pose& T_WI, double sigma_z, double sigma_tilt);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double z_;
  Eigen::Vector3d up_I_;
  Eigen::Vector3d weights_;
};

}  // namespace drydock::svin2
