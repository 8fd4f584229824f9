// Lays the path that vision saw on what the IMU felt (paper eq. 12-15, corrected).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "estimator/svin2/initialisation/depth_scale.h"
#include "estimator/svin2/initialisation/visual_window.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"

namespace drydock::svin2 {

struct GyroBiasEstimate {
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();  ///< [rad/s], in I.
  double chi2 = 0.0;
  int freedom = 0;  ///< chi2's expected value.
};

/// The bias with which the gyro's turns agree best with vision's, by linear least squares, each
/// weighed by both covariances, from N(0, prior_sigma). `imu[k]` spans frames k and k + 1.
GyroBiasEstimate EstimateGyroBias(const VisualMotion& motion,
                                  std::span<const ImuPreintegration> imu, double prior_sigma);

struct AlignmentPriors {
  ScaleEstimate scale;             ///< That vision is to be multiplied by.
  double gyro_bias_sigma = 0.01;   ///< [rad/s]
  double accel_bias_sigma = 0.05;  ///< [m/s^2]
};

/// In V, which is as vision left it; positions are those of the body.
struct Alignment {
  std::vector<Pose> T_VI;                               ///< By the scale below [m].
  std::vector<Eigen::Vector3d> v_V;                     ///< [m/s]
  Eigen::Vector3d gravity_V = Eigen::Vector3d::Zero();  ///< [m/s^2]
  double free_gravity = 0.0;  ///< Its length, when it was not yet held to be that of gravity.
  ScaleEstimate scale;        ///< After the prior and the IMU.
  ImuBias bias;
  double tilt_sigma_rad = 0.0;  ///< Standard deviations: of gravity's direction, the worse axis,
  double speed_sigma = 0.0;     ///< of the last velocity, the worst axis [m/s].
  double chi2 = 0.0;
  int freedom = 0;  ///< chi2's expected value.
};

/// First a linear least squares over velocities, gravity in three dimensions, scale, biases and
/// what vision got wrong; then the same with gravity on the sphere of its known length, over the
/// two angles that are left (Qin et al., VINS-Mono, T-RO 2018). Unlike there, every equation has
/// its covariance: the IMU's from pre-integration, vision's from its bundle adjustment, so that a
/// motion that hardly excites the accelerometer leaves the scale where its prior has it.
///
/// With c = p + R p_IC the camera's path by vision, the body is at s c - R p_IC: what is known of
/// the rig is its lever arm, not its scale. `imu[k]` spans frames k and k + 1. Nothing where the
/// equations have no solution.
std::optional<Alignment> Align(const VisualMotion& motion, std::span<const ImuPreintegration> imu,
                               const Eigen::Vector3d& p_IC, const AlignmentPriors& priors);

}  // namespace drydock::svin2
