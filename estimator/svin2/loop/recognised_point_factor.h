// Where both eyes see a landmark that was recognised by its looks.
#pragma once

#include <Eigen/Core>

#include <ceres/sized_cost_function.h>

#include "estimator/svin2/factors/reprojection_factor.h"
#include "estimator/svin2/frontend/stereo_geometry.h"

namespace drydock::svin2 {

/// Parameters: pose T_WI (7), landmark l [m, in W] (3). The corner that is found is not quite the
/// one that was known: seen from elsewhere, with other noise, it lies `offset_px` beside. That
/// error is the same in both eyes, whose corners are one and the same patch, so that their
/// covariance is, with each eye's own `sigma_px`,
///   sigma^2 [I 0; 0 I] + offset^2 [I I; I I].
/// Residual, with e_k = z_k - pi_k(T_IC_k^-1 T_WI^-1 l) (ReprojectionFactor):
///   [(e_0 + e_1) / sqrt(2 sigma^2 + 4 offset^2);  (e_0 - e_1) / (sqrt(2) sigma)]
/// Tangents: [dp, da], exp(da) q; dl.
class RecognisedPointFactor final : public ceres::SizedCostFunction<4, 7, 3> {
 public:
  RecognisedPointFactor(const StereoGeometry& rig, const Eigen::Vector2d& left,
                        const Eigen::Vector2d& right, double sigma_px, double offset_px);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  ReprojectionFactor left_, right_;  // Of standard deviation 1.
  double sum_weight_, difference_weight_;
};

}  // namespace drydock::svin2
