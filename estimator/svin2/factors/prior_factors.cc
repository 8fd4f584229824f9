#include "estimator/svin2/factors/prior_factors.h"

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

Eigen::Matrix<double, 6, 6> PoseWhitening(const Vector6d& sigmas) {
  Check(sigmas.minCoeff() > 0.0, "standard deviations of a pose must be above 0");
  return sigmas.cwiseInverse().asDiagonal();
}

bool PosePriorFactor::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  const Vector6d error = FromParameters(parameters[0]).BoxMinus(T_WI_);
  Eigen::Map<Vector6d>(residuals, 6) = whitening_ * error;
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Matrix<double, 6, 6> by_pose = whitening_;
  by_pose.rightCols<3>() = whitening_.rightCols<3>() * LeftJacobianInverseSO3(error.tail<3>());
  StorePoseJacobian<6>(parameters[0], by_pose, jacobians[0]);
  return true;
}

SpeedBiasPriorFactor::SpeedBiasPriorFactor(const SpeedBias& expected,
                                           const SpeedBiasSigmas& sigmas) {
  Check(sigmas.speed > 0.0 && sigmas.gyro_bias > 0.0 && sigmas.accel_bias > 0.0,
        "standard deviations of speed and biases must be above 0");
  expected_ << expected.v_W, expected.bias.gyro, expected.bias.accel;
  weights_ << Eigen::Vector3d::Constant(1.0 / sigmas.speed),
      Eigen::Vector3d::Constant(1.0 / sigmas.gyro_bias),
      Eigen::Vector3d::Constant(1.0 / sigmas.accel_bias);
}

bool SpeedBiasPriorFactor::Evaluate(double const* const* parameters, double* residuals,
                                    double** jacobians) const {
  using Vector9d = Eigen::Matrix<double, 9, 1>;
  Eigen::Map<Vector9d>(residuals, 9) =
      weights_.cwiseProduct(Eigen::Map<const Vector9d>(parameters[0]) - expected_);
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<Eigen::Matrix<double, 9, 9, Eigen::RowMajor>> block(jacobians[0]);
  block = weights_.asDiagonal();
  return true;
}

}  // namespace drydock::svin2
