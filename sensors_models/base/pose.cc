#include "sensors_models/base/pose.h"

#include <cmath>
#include <limits>

namespace drydock {

Eigen::Matrix3d Skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

Eigen::Quaterniond ExpSO3(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const double half = 0.5 * angle;
  // sin(x/2)/x, by its series where the quotient would lose digits.
  const double factor = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  const Eigen::Vector3d v = factor * rotation_vector;
  return Eigen::Quaterniond(std::cos(half), v.x(), v.y(), v.z());
}

Eigen::Vector3d LogSO3(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  const double cosine = sign * q.w();
  if (sine < 1e-7) return (2.0 * sign / cosine) * q.vec();
  return (2.0 * sign * std::atan2(sine, cosine) / sine) * q.vec();
}

Eigen::Matrix3d LeftJacobianSO3(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const double square = angle * angle;
  const Eigen::Matrix3d hat = Skew(phi);
  double first = 0.5 - square / 24.0;
  double second = 1.0 / 6.0 - square / 120.0;
  if (angle > 1e-2) {
    first = (1.0 - std::cos(angle)) / square;
    second = (angle - std::sin(angle)) / (square * angle);
  }
  return Eigen::Matrix3d::Identity() + first * hat + second * hat * hat;
}

Eigen::Matrix3d LeftJacobianInverseSO3(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const Eigen::Matrix3d hat = Skew(phi);
  double factor = 1.0 / 12.0 + angle * angle / 720.0;
  if (angle > 1e-3) {
    factor = 1.0 / (angle * angle) - (1.0 + std::cos(angle)) / (2.0 * angle * std::sin(angle));
  }
  return Eigen::Matrix3d::Identity() - 0.5 * hat + factor * hat * hat;
}

Eigen::Quaterniond FromYawPitchRoll(double yaw, double pitch, double roll) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

double YawOf(const Eigen::Quaterniond& q) {
  const Eigen::Vector3d forward = q * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

double YawBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  // The part about z of the turn between them.
  const Eigen::Quaterniond turn = to * from.conjugate();
  return std::atan2(2.0 * turn.w() * turn.z(), turn.w() * turn.w() - turn.z() * turn.z());
}

Pose::Pose(const Eigen::Quaterniond& q, const Eigen::Vector3d& p) : q_(q), p_(p) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (!(std::abs(q.squaredNorm() - 1.0) <= kRounding)) q_.normalize();
}

Pose Pose::Inverse() const {
  const Eigen::Quaterniond inverse = q_.conjugate();
  return {inverse, -(inverse * p_)};
}

Pose Pose::operator*(const Pose& other) const { return {q_ * other.q_, q_ * other.p_ + p_}; }

Pose Pose::BoxPlus(const Vector6d& delta) const {
  return {ExpSO3(delta.tail<3>()) * q_, p_ + delta.head<3>()};
}

Vector6d Pose::BoxMinus(const Pose& other) const {
  Vector6d delta;
  delta << p_ - other.p_, LogSO3(q_ * other.q_.conjugate());
  return delta;
}

}  // namespace drydock
