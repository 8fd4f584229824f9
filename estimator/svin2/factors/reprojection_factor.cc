#include "estimator/svin2/factors/reprojection_factor.h"

#include <optional>

#include "estimator/svin2/factors/pose_jacobian.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

using ByLandmark = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;

}  // namespace

ReprojectionFactor::ReprojectionFactor(const CameraModel& camera, const Pose& T_IC,
                                       const Eigen::Vector2d& pixel, double sigma_px)
    : camera_(camera), T_CI_(T_IC.Inverse()), pixel_(pixel), sigma_px_(sigma_px) {
  Check(sigma_px > 0.0, "a keypoint's standard deviation must be above 0, not {}", sigma_px);
}

bool ReprojectionFactor::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const Pose T_WI = FromParameters(parameters[0]);
  const Eigen::Map<const Eigen::Vector3d> landmark_W(parameters[1]);
  const Eigen::Vector3d from_body_W = landmark_W - T_WI.p();
  const std::optional<ProjectedPoint> seen =
      camera_.ProjectWithJacobian(T_CI_ * (T_WI.q().conjugate() * from_body_W));

  Eigen::Vector2d error(camera_.intrinsics().width + camera_.intrinsics().height, 0.0);
  ByLandmark by_landmark = ByLandmark::Zero();
  if (seen) {
    error = pixel_ - seen->pixel;
    by_landmark =
        -seen->by_point * (T_WI.q() * T_CI_.q().conjugate()).conjugate().toRotationMatrix();
  }
  Eigen::Map<Eigen::Vector2d>(residuals, 2) = error / sigma_px_;
  if (jacobians == nullptr) return true;

  by_landmark /= sigma_px_;
  if (jacobians[0] != nullptr) {
    // The body's shift moves the landmark the other way; turning the body by da moves it by -da x
    // (its place as seen from the body).
    Eigen::Matrix<double, 2, 6> by_pose;
    by_pose << -by_landmark, by_landmark * Skew(from_body_W);
    StorePoseJacobian<2>(parameters[0], by_pose, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<ByLandmark> block(jacobians[1]);
    block = by_landmark;
  }
  return true;
}

}  // namespace drydock::svin2
