#include "sensors_models/base/pose_manifold.h"

namespace drydock {
namespace {

using PlusMatrix = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;
using MinusMatrix = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

/// d(exp(da) * q)/d(da) at da = 0, rows in x y z w: half of the left product with a pure
/// quaternion.
Eigen::Matrix<double, 4, 3> QuaternionJacobian(const double* q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  Eigen::Matrix<double, 4, 3> jacobian;
  jacobian << w, z, -y, -z, w, x, y, -x, w, -x, -y, -z;
  return 0.5 * jacobian;
}

}  // namespace

PoseParameters ToParameters(const Pose& pose) {
  const auto& p = pose.p();
  const auto& q = pose.q();
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

Pose FromParameters(const double* parameters) {
  return {Eigen::Quaterniond(parameters[6], parameters[3], parameters[4], parameters[5]),
          Eigen::Vector3d(parameters[0], parameters[1], parameters[2])};
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Pose moved = FromParameters(x).BoxPlus(Eigen::Map<const Vector6d>(delta));
  const PoseParameters result = ToParameters(moved);
  std::copy(result.begin(), result.end(), x_plus_delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<PlusMatrix> plus(jacobian);
  plus.setZero();
  plus.topLeftCorner<3, 3>().setIdentity();
  plus.bottomRightCorner<4, 3>() = QuaternionJacobian(x + 3);
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6d> delta(y_minus_x);
  delta = FromParameters(y).BoxMinus(FromParameters(x));
  return true;
}

bool PoseManifold::MinusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<MinusMatrix> minus(jacobian);
  minus.setZero();
  minus.topLeftCorner<3, 3>().setIdentity();
  // The columns of QuaternionJacobian are orthogonal with length 1/2: four times its transpose
  // is its left inverse.
  minus.bottomRightCorner<3, 4>() = 4.0 * QuaternionJacobian(x + 3).transpose();
  return true;
}

}  // namespace drydock
