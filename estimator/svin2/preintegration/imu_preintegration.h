// The motion between two frames that IMU samples alone tell, whatever the state at the first one.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "estimator/svin2/preintegration/imu_segments.h"

namespace drydock::svin2 {

struct ImuBias {
  Eigen::Vector3d gyro = Eigen::Vector3d::Zero();   ///< [rad/s], in I.
  Eigen::Vector3d accel = Eigen::Vector3d::Zero();  ///< [m/s^2], in I.
};

/// With i and j the two instants, T apart, and g gravity (paper eq. 13 and 14; there alpha, gamma,
/// beta):
///   p  = R_WI,i' (p_j - p_i - v_i T - g T^2 / 2)   [m]
///   q  = R_WI,i' R_WI,j
///   v  = R_WI,i' (v_j - v_i - g T)                 [m/s]
/// all in the body's frame at i.
struct ImuDelta {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
};

/// Derivatives of [p, q, v] (q by left perturbation, exp(d) q, in the body's frame at i) by
/// [gyro bias, accelerometer bias].
using ImuBiasJacobian = Eigen::Matrix<double, 9, 6>;

/// Of the error [p, q, v, gyro bias, accel bias] = truth - delta, q as in ImuBiasJacobian, biases
/// as their walk from i to j. The order is that of the state's tangent (paper eq. 2).
using ImuCovariance = Eigen::Matrix<double, 15, 15>;

/// Pre-integrated samples (Forster et al., "On-Manifold Preintegration", T-RO 2017), by the
/// trapezoidal rule of IntegrateMidpoint(): error of second order in the IMU's period. Unlike in
/// that paper, rotations are perturbed on the left, as everywhere in Drydock, and the biases' walk
/// within the interval is part of the covariance, correlations included.
class ImuPreintegration {
 public:
  /// Deltas with the biases `bias` taken off. Over an empty interval (end == begin) they are 0, and
  /// so is the covariance. Nothing if end < begin or if there are no usable samples; what is usable
  /// and how ends, gaps and saturation are treated says CutImuSegments(). `samples` should include
  /// one at or before `begin` and one at or after `end`.
  static std::optional<ImuPreintegration> Over(std::span<const TimedImuSample> samples, Time begin,
                                               Time end, const ImuBias& bias,
                                               const ImuNoiseModel& noise);

  Time begin() const { return begin_; }
  Time end() const { return end_; }
  Duration length() const { return end_ - begin_; }
  const ImuBias& bias() const { return bias_; }     ///< At which the deltas were integrated.
  const ImuDelta& delta() const { return delta_; }  ///< At bias().
  const ImuBiasJacobian& bias_jacobian() const { return bias_jacobian_; }  ///< At bias().
  const ImuCovariance& covariance() const { return covariance_; }

  /// The deltas at another bias, to first order.
  ImuDelta DeltaAt(const ImuBias& bias) const;
  /// Whether DeltaAt(bias) is too coarse: the gyro's biases differ by more than 1e-4 rad in total
  /// over the interval. (The deltas are linear in the accelerometer's.)
  bool NeedsReintegration(const ImuBias& bias) const;
  /// The same samples integrated at another bias.
  ImuPreintegration IntegratedAt(const ImuBias& bias) const;

 private:
  ImuPreintegration(Time begin, Time end, std::vector<ImuSegment> segments,
                    const ImuNoiseModel& noise, const ImuBias& bias);
  void AddSegment(const ImuSegment& segment);

  Time begin_, end_;
  std::vector<ImuSegment> segments_;
  ImuNoiseModel noise_;
  ImuBias bias_;
  ImuDelta delta_;
  ImuBiasJacobian bias_jacobian_ = ImuBiasJacobian::Zero();
  ImuCovariance covariance_ = ImuCovariance::Zero();
};

}  // namespace drydock::svin2
