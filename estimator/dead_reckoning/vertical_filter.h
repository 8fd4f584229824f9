// Keeps inertial height honest by the pressure sensor.
#pragma once

#include <Eigen/Core>

namespace drydock {

/// A Kalman filter over what inertial navigation gets wrong in the vertical: the errors of height
/// [m], vertical speed [m/s] and vertical acceleration [m/s^2] (accelerometer bias and tilt
/// together).
class VerticalFilter {
 public:
  struct Config {
    double acceleration_noise =
        7e-3;                 ///< White, of the inertial vertical acceleration [m/s^2/sqrt(Hz)].
    double bias_walk = 3e-4;  ///< Of the acceleration's error [m/s^3/sqrt(Hz)].
    double initial_height = 0.01;  ///< Standard deviations at the start: [m],
    double initial_speed = 0.01;   ///< [m/s],
    double initial_bias = 0.02;    ///< [m/s^2].
    double depth_noise = 0.01;     ///< Of a depth reading [m].
  };

  explicit VerticalFilter(const Config& config);

  /// Time passes: the errors grow.
  void Predict(double dt);
  /// A depth reading says that height is `measured_minus_predicted` [m] above what is believed.
  /// Returns what to add to height, vertical speed and vertical acceleration.
  Eigen::Vector3d Update(double measured_minus_predicted);

 private:
  Config config_;
  Eigen::Matrix3d covariance_;
};

}  // namespace drydock
