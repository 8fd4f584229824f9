// The manifold on which Ceres optimises poses.
#pragma once

#include <array>

#include <ceres/manifold.h>

#include "sensors_models/base/pose.h"

namespace drydock {

/// A pose as Ceres holds it: [p (m), q as x y z w].
using PoseParameters = std::array<double, 7>;

PoseParameters ToParameters(const Pose& pose);
Pose FromParameters(const double* parameters);

/// Left perturbation with tangent [dp, da] [m, rad]: p + dp, exp(da) * q, as Pose::BoxPlus. Unlike
/// ceres::EigenQuaternionManifold, da is the full angle, so that covariances come out in radians.
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

}  // namespace drydock
