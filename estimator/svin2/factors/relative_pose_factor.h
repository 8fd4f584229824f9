// What was measured of one pose as seen from another (paper eq. 17).
#pragma once

#include <ceres/sized_cost_function.h>

#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// The inverse L^-1 of the Cholesky factor of a covariance L L^T: what makes its error white, with
/// unit variance. std::logic_error unless the covariance is finite and positive definite.
Eigen::Matrix<double, 6, 6> WhiteningOf(const Eigen::Matrix<double, 6, 6>& covariance);

/// Parameters: pose i T_WI,i (7), pose j T_WI,j (7). Residual, with D = T_WI,i^-1 T_WI,j and the
/// measured T_ij = (p_ij, q_ij):
///   e = A [p_D - p_ij; Log(q_D q_ij^-1)] = A (D - T_ij as Pose::BoxMinus)   [m; rad], in I at i
/// Eq. 17 as printed, T_i T_j^-1, is this only where its T is T_IW; with T_WI it would tie the
/// measurement to where in the world the pair lies. A whitens: with A = L^-1 of the covariance of a
/// measured T_ij = D.BoxPlus([n_p; n_a]) (see WhiteningOf) e has unit variance; any 6 x 6 will do.
/// Tangents: [dp, da], exp(da) q, in W.
///
/// Where D is half a turn away from T_ij, Log jumps from one side to the other; value and
/// derivatives are those of the side that the rounding falls to, and finite.
class RelativePoseFactor final : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  RelativePoseFactor(const Pose& T_ij, const Eigen::Matrix<double, 6, 6>& whitening)
      : T_ij_(T_ij), whitening_(whitening) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Pose T_ij_;
  Eigen::Matrix<double, 6, 6> whitening_;
};

}  // namespace drydock::svin2
