#include "estimator/svin2/factors/body_velocity_factor.h"

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

BodyVelocityFactor::BodyVelocityFactor(const Eigen::Vector3d& v_I, double sigma)
    : v_I_(v_I), sigma_(sigma) {
  Check(sigma_ > 0.0, "a velocity's standard deviation must be above 0, not {}", sigma_);
}

bool BodyVelocityFactor::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const Eigen::Matrix3d R_IW =
      FromParameters(parameters[0]).q().conjugate().toRotationMatrix() / sigma_;
  const Eigen::Map<const Eigen::Vector3d> v_W(parameters[1]);
  Eigen::Map<Eigen::Vector3d>(residuals, 3) = R_IW * v_W - v_I_ / sigma_;
  if (jacobians == nullptr) return true;

  if (jacobians[0] != nullptr) {
    Eigen::Matrix<double, 3, 6> by_pose = Eigen::Matrix<double, 3, 6>::Zero();
    by_pose.rightCols<3>() = R_IW * Skew(v_W);
    StorePoseJacobian<3>(parameters[0], by_pose, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 3, 9, Eigen::RowMajor>> block(jacobians[1]);
    block.setZero();
    block.leftCols<3>() = R_IW;
  }
  return true;
}

}  // namespace drydock::svin2
