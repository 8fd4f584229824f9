#include "estimator/svin2/factors/depth_factor.h"

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

DepthFactor::DepthFactor(const DepthObservation& observation)
    : depth_(observation.depth),
      p_ID_(observation.p_ID),
      dt_(observation.since_frame.Seconds()),
      sigma_(observation.sigma) {
  Check(sigma_ > 0.0, "a depth's standard deviation must be above 0, not {}", sigma_);
}

bool DepthFactor::Evaluate(double const* const* parameters, double* residuals,
                           double** jacobians) const {
  const Pose T_WI = FromParameters(parameters[0]);
  const double v_z = parameters[1][2];
  const double surface = parameters[2][0];
  const Eigen::Vector3d lever_W = T_WI.q() * p_ID_;
  residuals[0] = (T_WI.p().z() + lever_W.z() + v_z * dt_ + depth_ - surface) / sigma_;
  if (jacobians == nullptr) return true;

  if (jacobians[0] != nullptr) {
    Eigen::Matrix<double, 1, 6> by_pose;
    by_pose << Eigen::RowVector3d::UnitZ(), -Skew(lever_W).row(2);
    StorePoseJacobian<1>(parameters[0], by_pose / sigma_, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 1, 9>> block(jacobians[1]);
    block.setZero();
    block[2] = dt_ / sigma_;
  }
  if (jacobians[2] != nullptr) jacobians[2][0] = -1.0 / sigma_;
  return true;
}

}  // namespace drydock::svin2
