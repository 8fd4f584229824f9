#include "estimator/inertial/imu_integration.h"

namespace drydock {

NavState IntegrateMidpoint(const NavState& state, const ImuSample& before, const ImuSample& after,
                           Time t_after) {
  const double dt = (t_after - state.t).Seconds();
  const Eigen::Vector3d rate = 0.5 * (before.angular_rate + after.angular_rate) - state.gyro_bias;
  const Eigen::Quaterniond q_after = state.T_WI.q() * ExpSO3(rate * dt);
  const Eigen::Vector3d force_before = state.T_WI.q() * (before.specific_force - state.accel_bias);
  const Eigen::Vector3d force_after = q_after * (after.specific_force - state.accel_bias);
  const Eigen::Vector3d acceleration = 0.5 * (force_before + force_after) + kGravity;

  NavState next = state;
  next.t = t_after;
  next.T_WI = Pose(q_after, state.T_WI.p() + state.v_W * dt + 0.5 * acceleration * dt * dt);
  next.v_W = state.v_W + acceleration * dt;
  return next;
}

}  // namespace drydock
