#include "estimator/svin2/window/propagate.h"

#include "estimator/inertial/imu_integration.h"

namespace drydock::svin2 {

NavState Propagate(const NavState& state, const ImuPreintegration& imu) {
  const ImuBias bias = {state.gyro_bias, state.accel_bias};
  const ImuDelta delta =
      imu.NeedsReintegration(bias) ? imu.IntegratedAt(bias).delta() : imu.DeltaAt(bias);
  const double T = imu.length().Seconds();
  const Eigen::Quaterniond& q = state.T_WI.q();
  NavState next = state;
  next.t = imu.end();
  next.T_WI =
      Pose(q * delta.q, state.T_WI.p() + state.v_W * T + 0.5 * T * T * kGravity + q * delta.p);
  next.v_W = state.v_W + T * kGravity + q * delta.v;
  return next;
}

}  // namespace drydock::svin2
