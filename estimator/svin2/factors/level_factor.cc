#include "estimator/svin2/factors/level_factor.h"

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {

LevelFactor::LevelFactor(const Pose& T_WI, double sigma_z, double sigma_tilt)
    : z_(T_WI.p().z()),
      up_I_(T_WI.q().conjugate() * Eigen::Vector3d::UnitZ()),
      weights_(1.0 / sigma_z, 1.0 / sigma_tilt, 1.0 / sigma_tilt) {
  Check(sigma_z > 0.0 && sigma_tilt > 0.0,
        "standard deviations of height and tilt must be above 0");
}

bool LevelFactor::Evaluate(double const* const* parameters, double* residuals,
                           double** jacobians) const {
  const Pose T_WI = FromParameters(parameters[0]);
  const Eigen::Vector3d up = T_WI.q() * up_I_;
  Eigen::Map<Eigen::Vector3d>(residuals, 3) =
      weights_.cwiseProduct(Eigen::Vector3d(T_WI.p().z() - z_, up.x(), up.y()));
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  // da turns u by da x u.
  Eigen::Matrix<double, 3, 6> by_pose = Eigen::Matrix<double, 3, 6>::Zero();
  by_pose(0, 2) = 1.0;
  by_pose.bottomRightCorner<2, 3>() = -Skew(up).topRows<2>();
  StorePoseJacobian<3>(parameters[0], weights_.asDiagonal() * by_pose, jacobians[0]);
  return true;
}

}  // namespace drydock::svin2
