#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "estimator/svin2/initialisation/visual_inertial_alignment.h"

namespace drydock::svin2 {

GyroBiasEstimate EstimateGyroBias(const VisualMotion& motion,
                                  std::span<const ImuPreintegration> imu, double prior_sigma) {
  const Eigen::MatrixXd visual = motion.information.inverse();
  // Of the turn between frames k and k + 1, in the body's frame at k; the first pose is exact.
  const auto visual_covariance = [&](int k) -> Eigen::Matrix3d {
    const int j = 6 * k + 3, i = j - 6;
    Eigen::Matrix3d of_turn = visual.block<3, 3>(j, j);
    if (k > 0) {
      of_turn += visual.block<3, 3>(i, i) - visual.block<3, 3>(i, j) - visual.block<3, 3>(j, i);
    }
    const Eigen::Matrix3d R = motion.T_VI[k].R();
    return R.transpose() * of_turn * R;
  };
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() / (prior_sigma * prior_sigma);
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (int k = 0; k < std::ssize(imu); ++k) {
    const Eigen::Quaterniond turn = motion.T_VI[k].q().conjugate() * motion.T_VI[k + 1].q();
    const Eigen::Vector3d error = LogSO3(turn * imu[k].delta().q.conjugate());
    const Eigen::Matrix3d by_bias = imu[k].bias_jacobian().block<3, 3>(3, 0);
    const Eigen::Matrix3d information =
        (imu[k].covariance().block<3, 3>(3, 3) + visual_covariance(k)).inverse();
    normal += by_bias.transpose() * information * by_bias;
    right += by_bias.transpose() * information * error;
    squares += error.dot(information * error);
  }
  GyroBiasEstimate estimate;
  const Eigen::Vector3d change = normal.ldlt().solve(right);
  if (!imu.empty()) estimate.bias = imu[0].bias().gyro;
  estimate.bias += change;
  estimate.chi2 = squares - change.dot(right);
  estimate.freedom = 3 * static_cast<int>(imu.size());
  return estimate;
}

}  // namespace drydock::svin2
