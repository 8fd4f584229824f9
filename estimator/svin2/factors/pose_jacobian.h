// Derivatives by a pose, in the form that Ceres wants.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose_manifold.h"

namespace drydock::svin2 {

/// Stores the derivatives of R residuals (Eigen::Dynamic for any number) by a pose's tangent [dp,
/// da] as Ceres' row-major R x 7 block of derivatives by its parameters. Ceres multiplies these by
/// PlusJacobian on the right; its left inverse MinusJacobian gives `by_tangent` back, exactly.
template <int R>
void StorePoseJacobian(const double* pose_parameters, const Eigen::Matrix<double, R, 6>& by_tangent,
                       double* jacobian) {
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> minus;
  PoseManifold().MinusJacobian(pose_parameters, minus.data());
  Eigen::Map<Eigen::Matrix<double, R, 7, Eigen::RowMajor>> ambient(jacobian, by_tangent.rows(), 7);
  ambient = by_tangent * minus;
}

}  // namespace drydock::svin2
