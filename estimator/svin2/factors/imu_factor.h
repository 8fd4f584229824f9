// The motion that the IMU saw against two states (e_s of paper eq. 3).
#pragma once

#include <ceres/sized_cost_function.h>

#include "estimator/inertial/imu_integration.h"
#include "estimator/svin2/factors/speed_bias.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// Parameters: pose i (7), speed and biases i (9), pose j (7), speed and biases j (9). With R =
/// R_WI at i, T the interval and p, q, v the deltas at the biases of i (paper eq. 14), the
/// residuals are
///   e_p  = R' (p_j - p_i - v_i T - g T^2 / 2) - p
///   e_a  = Log(q_i^-1 q_j q^-1)
///   e_v  = R' (v_j - v_i - g T) - v
///   e_bg = b_g,j - b_g,i,   e_ba = b_a,j - b_a,i
/// all in the body's frame at i, whitened by the inverse Cholesky factor of the pre-integration's
/// covariance. Tangents: [dp, da], exp(da) q; [dv, db_g, db_a].
///
/// Where the gyro's bias has moved too far for the deltas' first order, each evaluation integrates
/// anew (some microseconds a sample), so that the cost is a function of the parameters alone. The
/// covariance stays that of the construction. Who owns the factor saves time by replacing it by one
/// from ImuPreintegration::IntegratedAt() between optimisations.
class ImuFactor final : public ceres::SizedCostFunction<15, 7, 9, 7, 9> {
 public:
  /// std::logic_error if the interval is empty: it has no information, and a covariance of 0.
  explicit ImuFactor(ImuPreintegration preintegration, const Eigen::Vector3d& gravity_W = kGravity);

  const ImuPreintegration& preintegration() const { return preintegration_; }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  struct Errors;
  Errors ErrorsAt(const Pose& T_i, const SpeedBias& s_i, const Pose& T_j,
                  const SpeedBias& s_j) const;

  ImuPreintegration preintegration_;
  Eigen::Vector3d gravity_W_;
  Eigen::Matrix<double, 15, 15> whitening_;
};

}  // namespace drydock::svin2
