// Rigid transforms. T_AB maps points of frame B into frame A, and adjacent letters cancel:
// p_A = T_AB * p_B, T_AC = T_AB * T_BC.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace drydock {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// The matrix with Skew(a) * b = a x b.
Eigen::Matrix3d Skew(const Eigen::Vector3d& a);

/// Rotation by |rotation_vector| radians about its direction; exact to machine precision near zero.
Eigen::Quaterniond ExpSO3(const Eigen::Vector3d& rotation_vector);

/// The rotation vector of q [rad], with angle in [0, pi].
Eigen::Vector3d LogSO3(const Eigen::Quaterniond& q);

/// SO(3)'s left Jacobian: Exp(phi + d) = Exp(LeftJacobianSO3(phi) * d) * Exp(phi) to first order in
/// d.
Eigen::Matrix3d LeftJacobianSO3(const Eigen::Vector3d& phi);

/// The inverse of SO(3)'s left Jacobian: Log(Exp(d) * Exp(phi)) = phi + LeftJacobianInverseSO3(phi)
/// * d to first order in d.
Eigen::Matrix3d LeftJacobianInverseSO3(const Eigen::Vector3d& phi);

/// Rotation from yaw about z, then pitch about the new y, then roll about the newest x [rad]:
/// Rz(yaw) Ry(pitch) Rx(roll). With x forward and z up, positive pitch looks down.
Eigen::Quaterniond FromYawPitchRoll(double yaw, double pitch, double roll);

/// The yaw of R [rad] in (-pi, pi], where R = Rz(yaw) Ry(pitch) Rx(roll).
double YawOf(const Eigen::Quaterniond& q);

/// The turn about z [rad] in (-pi, pi] that takes `from` as near to `to` as such a turn can. Unlike
/// a difference of YawOf() it does not mind which of the body's axes is forward: of a body whose x
/// is up, YawOf() is noise.
double YawBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to);

/// An element of SE(3): a unit quaternion and a translation [m].
class Pose {
 public:
  Pose() = default;
  /// Normalises `q`, unless its length is 1 to rounding already: what was normalised once keeps its
  /// bits, so that a pose survives being written and read. Which sign of the quaternion is kept
  /// does not matter anywhere.
  Pose(const Eigen::Quaterniond& q, const Eigen::Vector3d& p);

  static Pose Identity() { return {}; }

  const Eigen::Quaterniond& q() const { return q_; }
  const Eigen::Vector3d& p() const { return p_; }
  Eigen::Matrix3d R() const { return q_.toRotationMatrix(); }

  Pose Inverse() const;
  Pose operator*(const Pose& other) const;
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return q_ * point + p_; }

  /// The project's left perturbation (the tangent of every factor), delta = [dp; da] [m; rad] in
  /// the outer frame: p + dp, exp(da) * q.
  Pose BoxPlus(const Vector6d& delta) const;
  /// The inverse of BoxPlus: `*this` = other.BoxPlus(this->BoxMinus(other)).
  Vector6d BoxMinus(const Pose& other) const;

 private:
  Eigen::Quaterniond q_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p_ = Eigen::Vector3d::Zero();
};

}  // namespace drydock
