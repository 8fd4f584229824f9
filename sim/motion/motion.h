// The truth of how the body moves.
#pragma once

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::sim {

/// Gravity [m/s^2], in W (z up).
inline const Eigen::Vector3d kGravity_W(0.0, 0.0, -9.81);

/// The body's exact motion at an instant.
struct MotionState {
  Pose T_WI;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< Velocity of I [m/s], in W.
  Eigen::Vector3d a_W = Eigen::Vector3d::Zero();  ///< Acceleration of I [m/s^2], in W.
  Eigen::Vector3d w_I = Eigen::Vector3d::Zero();  ///< Angular rate of I against W [rad/s], in I.
};

/// Gives the truth at any instant from 0 to End().
class Motion {
 public:
  virtual ~Motion() = default;
  virtual MotionState At(Time t) const = 0;
  virtual Time End() const = 0;
};

}  // namespace drydock::sim
