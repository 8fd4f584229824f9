// Height by pressure (paper eq. 8, 9).
#pragma once

#include <ceres/sized_cost_function.h>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// The reading d0 to which all others are relative.
struct DepthReference {
  double depth = 0.0;     ///< d0 [m, positive downwards].
  double height_W = 0.0;  ///< z of the pressure port in W when d0 was read [m].
};

struct DepthObservation {
  double depth = 0.0;                              ///< d [m, positive downwards].
  Eigen::Vector3d p_ID = Eigen::Vector3d::Zero();  ///< The pressure port [m, in I].
  /// Time of the reading less that of the frame whose state the factor is tied to.
  Duration since_frame;
  double sigma = 0.0;  ///< Standard deviation of d - d0 [m], > 0.
};

/// Parameters: pose T_WI (7), speed and biases (9) of the frame nearest to the reading. With the
/// lever arm R p_ID and the time dt from frame to reading, the residual is
///   e = (p_z + (R p_ID)_z + v_z dt - (height_W - (d - d0))) / sigma
/// signed, where eq. 9 prints an absolute value, which has no derivative at its minimum. W's z is
/// up, so that depth counts down. Tangents: [dp, da], exp(da) q; [dv, db_g, db_a]:
///   de/dp = e_z',   de/da = -e_z' [R p_ID]x,   de/dv = dt e_z'   (each over sigma)
///
/// Acceleration and turning during dt are left out: at most 1/2 a dt^2 + |w x p_ID| dt, which for a
/// frame every 1/15 s, so dt to 1/30 s, 0.5 m/s^2 and 0.1 rad/s about an arm of 0.3 m is 1.3 mm.
class DepthFactor final : public ceres::SizedCostFunction<1, 7, 9> {
 public:
  DepthFactor(const DepthObservation& observation, const DepthReference& reference);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double height_W_;  ///< Of the pressure port by the reading [m].
  Eigen::Vector3d p_ID_;
  double dt_;  ///< [s]
  double sigma_;
};

}  // namespace drydock::svin2
