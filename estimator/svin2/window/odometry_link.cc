#include "estimator/svin2/window/odometry_link.h"

namespace drydock::svin2 {

OdometryLink LinkBetween(const Pose& T_W_before, const Pose& T_W_now,
                         const Eigen::Matrix<double, 12, 12>& covariance) {
  const Eigen::Matrix3d R_IW = T_W_before.R().transpose();
  Eigen::Matrix<double, 6, 12> J = Eigen::Matrix<double, 6, 12>::Zero();
  J.block<3, 3>(0, 0) = J.block<3, 3>(3, 3) = -R_IW;
  J.block<3, 3>(0, 6) = J.block<3, 3>(3, 9) = R_IW;
  J.block<3, 3>(0, 3) = R_IW * Skew(T_W_now.p() - T_W_before.p());
  return {T_W_before.Inverse() * T_W_now, J * covariance * J.transpose()};
}

}  // namespace drydock::svin2
