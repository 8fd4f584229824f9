// What is known of a state beforehand.
#pragma once

#include <ceres/sized_cost_function.h>

#include "estimator/svin2/factors/speed_bias.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// The square root L^-1 of an information matrix, from standard deviations.
Eigen::Matrix<double, 6, 6> PoseWhitening(const Vector6d& sigmas);

/// Parameters: pose T_WI (7). Residual: e = A [p - p0; Log(q q0^-1)], A any 6 x 6 matrix (rows of 0
/// leave a direction free). Tangent: [dp, da], exp(da) q, in W: the last of the six is yaw.
class PosePriorFactor final : public ceres::SizedCostFunction<6, 7> {
 public:
  PosePriorFactor(const Pose& T_WI, const Eigen::Matrix<double, 6, 6>& whitening)
      : T_WI_(T_WI), whitening_(whitening) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Pose T_WI_;
  Eigen::Matrix<double, 6, 6> whitening_;
};

/// Standard deviations of a first state whose velocity and biases are unknown; those that OKVIS
/// starts from.
struct SpeedBiasSigmas {
  double speed = 1.0;       ///< [m/s]
  double gyro_bias = 0.03;  ///< [rad/s]
  double accel_bias = 0.1;  ///< [m/s^2]
};

/// Parameters: speed and biases (9). Residual: each less its expected value, over its standard
/// deviation.
class SpeedBiasPriorFactor final : public ceres::SizedCostFunction<9, 9> {
 public:
  /// All `sigmas` > 0.
  SpeedBiasPriorFactor(const SpeedBias& expected, const SpeedBiasSigmas& sigmas);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Matrix<double, 9, 1> expected_, weights_;
};

}  // namespace drydock::svin2
