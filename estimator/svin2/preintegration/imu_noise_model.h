// What the estimator believes of its IMU's noise.
#pragma once

#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

/// White noise and random walks, each the same on three axes. The defaults are those that SVIn2's
/// authors give their estimator for the v3 rig: ten times what they measured, which leaves room for
/// scale errors, vibration and errors of integration. All four must be above 0.
struct ImuNoiseModel {
  double gyro_noise_density = 1.6e-3;   ///< [rad/s/sqrt(Hz)]
  double accel_noise_density = 7.1e-3;  ///< [m/s^2/sqrt(Hz)]
  double gyro_bias_walk = 1.65e-5;      ///< [rad/s^2/sqrt(Hz)]
  double accel_bias_walk = 2.9e-4;      ///< [m/s^3/sqrt(Hz)]
  double gyro_range = 0.0;              ///< Readings from here on are saturated [rad/s]; 0: none.
  double accel_range = 0.0;             ///< Readings from here on are saturated [m/s^2]; 0: none.
  /// White noise is multiplied by this where a reading is saturated and in gaps.
  double doubt_factor = 100.0;
  /// Samples further apart than this leave a gap [s].
  double longest_step_s = 0.05;
};

/// The sheet's noise times `inflation`; a value that the sheet does not have stays at its default.
///
/// Scale errors and misalignment, where the sheet has them, count as walks of the biases. They move
/// a reading by M x, with x the rate or the force: a bias that changes as x does. An axis has its
/// own scale error s and leans towards two others by n, m^2 = s^2 + 2 n^2; where x changes within a
/// time T by c sqrt(T), that bias walks with m c.
ImuNoiseModel NoiseModelOf(const ImuSheet& sheet, double inflation);

}  // namespace drydock::svin2
