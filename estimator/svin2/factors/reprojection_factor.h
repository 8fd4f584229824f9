// Where a camera saw a landmark (e_r of paper eq. 3).
#pragma once

#include <ceres/sized_cost_function.h>

#include "sensors_models/base/pose.h"
#include "sensors_models/models/camera_model.h"

namespace drydock::svin2 {

/// Parameters: pose T_WI (7), landmark l [m, in W] (3). Residual, with the camera's projection pi
/// (distortion included) and the keypoint z:
///   e = (z - pi(T_IC^-1 T_WI^-1 l)) / sigma   [px / px]
/// Tangents: [dp, da], exp(da) q; dl.
///
/// Landmarks are Euclidean, not homogeneous as OKVIS has them: water hides what is further away
/// than some 20 m, where a stereo pair of 14 cm still has a disparity of 4 px, so that no landmark
/// is near infinity; and the sonar's factor needs the mean of several.
///
/// A landmark at or behind the camera's plane costs a constant, as much as an error of the image's
/// width plus height in x, with derivatives of 0: it neither pulls nor breaks the optimisation, and
/// no step gains by pushing a landmark there.
class ReprojectionFactor final : public ceres::SizedCostFunction<2, 7, 3> {
 public:
  /// `pixel` in the distorted image; `sigma_px` > 0 is its standard deviation [px].
  ReprojectionFactor(const CameraModel& camera, const Pose& T_IC, const Eigen::Vector2d& pixel,
                     double sigma_px);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  CameraModel camera_;
  Pose T_CI_;
  Eigen::Vector2d pixel_;
  double sigma_px_;
};

}  // namespace drydock::svin2
