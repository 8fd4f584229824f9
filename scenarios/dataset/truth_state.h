// What a recording knows about the body that no sensor says.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::dataset {

/// The body's true state, and the true biases of its IMU.
struct TruthState {
  Pose T_WI;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();         ///< [m/s], in W.
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();   ///< [rad/s], in I.
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();  ///< [m/s^2], in I.
};

struct StampedTruth {
  Time t;
  TruthState state;
  bool pose_only = false;  ///< Velocity and biases are not known and stand at zero.
};

}  // namespace drydock::dataset
