// Height by pressure (paper eq. 8, 9).
#pragma once

#include <ceres/sized_cost_function.h>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::svin2 {

struct DepthObservation {
  double depth = 0.0;                              ///< d [m, positive downwards].
  Eigen::Vector3d p_ID = Eigen::Vector3d::Zero();  ///< The pressure port [m, in I].
  /// Time at which the reading was true less that of the frame whose state the factor is tied to.
  Duration since_frame;
  double sigma = 0.0;  ///< Standard deviation of this one reading [m], > 0.
};

/// Parameters: pose T_WI (7), speed and biases (9) of the frame nearest to the reading, and the
/// height h of the surface in W (1), where the sensor would read 0 [m]. With the lever arm R p_ID
/// and the time dt from frame to reading, the residual is
///   e = (p_z + (R p_ID)_z + v_z dt + d - h) / sigma
/// signed, where eq. 9 prints an absolute value, which has no derivative at its minimum. W's z is
/// up, so that depth counts down. Tangents: [dp, da], exp(da) q; [dv, db_g, db_a]; dh:
///   de/dp = e_z',   de/da = -e_z' [R p_ID]x,   de/dv = dt e_z',   de/dh = -1   (each over sigma)
///
/// In the paper h is z_0 + d_0, the port's height and the reading at the start, taken for exact.
/// That reading is as wrong as any other and all others lean on it: a constant error that no
/// covariance would show.
///
/// Acceleration and turning during dt are left out: see SlidingWindow::AddDepth().
class DepthFactor final : public ceres::SizedCostFunction<1, 7, 9, 1> {
 public:
  explicit DepthFactor(const DepthObservation& observation);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double depth_;
  Eigen::Vector3d p_ID_;
  double dt_;  ///< [s]
  double sigma_;
};

}  // namespace drydock::svin2
