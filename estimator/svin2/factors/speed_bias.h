// Velocity and biases as one block of parameters.
#pragma once

#include <Eigen/Core>
#include <array>

#include "estimator/svin2/preintegration/imu_preintegration.h"

namespace drydock::svin2 {

/// What a frame's state has beside its pose (paper eq. 1).
struct SpeedBias {
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s], in W.
  ImuBias bias;
};

/// As Ceres holds it: [v_W (m/s), gyro bias (rad/s), accelerometer bias (m/s^2)].
using SpeedBiasParameters = std::array<double, 9>;

inline SpeedBiasParameters ToParameters(const SpeedBias& state) {
  const Eigen::Vector3d &v = state.v_W, &g = state.bias.gyro, &a = state.bias.accel;
  return {v.x(), v.y(), v.z(), g.x(), g.y(), g.z(), a.x(), a.y(), a.z()};
}

inline SpeedBias SpeedBiasFromParameters(const double* parameters) {
  const auto triple = [parameters](int k) -> Eigen::Vector3d {
    return {parameters[k], parameters[k + 1], parameters[k + 2]};
  };
  return {triple(0), {triple(3), triple(6)}};
}

}  // namespace drydock::svin2
