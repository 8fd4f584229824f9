#include "estimator/svin2/factors/relative_pose_factor.h"

#include <Eigen/Cholesky>

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

Matrix6d WhiteningOf(const Matrix6d& covariance) {
  const Eigen::LLT<Matrix6d> cholesky(covariance);
  Check(covariance.allFinite() && cholesky.info() == Eigen::Success,
        "a covariance must be finite and positive definite");
  return cholesky.matrixL().solve(Matrix6d::Identity());
}

bool RelativePoseFactor::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const Pose T_i = FromParameters(parameters[0]);
  const Pose T_j = FromParameters(parameters[1]);
  const Vector6d error = (T_i.Inverse() * T_j).BoxMinus(T_ij_);
  Eigen::Map<Vector6d>(residuals, 6) = whitening_ * error;
  if (jacobians == nullptr) return true;

  // Both turns reach e_a as seen from the body at i, before the measured turn is taken off.
  const Eigen::Matrix3d R_IW = T_i.q().conjugate().toRotationMatrix();
  Matrix6d by_j = Matrix6d::Zero();
  by_j.topLeftCorner<3, 3>() = R_IW;
  by_j.bottomRightCorner<3, 3>() = LeftJacobianInverseSO3(error.tail<3>()) * R_IW;
  if (jacobians[0] != nullptr) {
    Matrix6d by_i = -by_j;
    by_i.topRightCorner<3, 3>() = R_IW * Skew(T_j.p() - T_i.p());
    StorePoseJacobian<6>(parameters[0], whitening_ * by_i, jacobians[0]);
  }
  if (jacobians[1] != nullptr) StorePoseJacobian<6>(parameters[1], whitening_ * by_j, jacobians[1]);
  return true;
}

}  // namespace drydock::svin2
