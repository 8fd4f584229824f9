// What a real IMU adds to the truth. For gyroscope and accelerometer alike:
//
//   measured = quantise(saturate(M truth + bias + white)),   M = (I + diag(s)) (I + N)
//
// s      scale errors: one Gaussian number an axis, drawn once a seed
// N      misalignment: zero diagonal; N(i, j) is the angle [rad] by which axis i leans towards axis
//        j. Six Gaussian numbers, drawn once a seed: the antisymmetric part is a wrong mounting,
//        the symmetric part axes that are not square to each other. Of first order: cosines are 1.
// bias   starts at a Gaussian vector and walks: density * sqrt(dt) a step
// white  density / sqrt(dt) a sample
// The rest is Digitise() on each axis. Each effect has a random stream of its own
// ("imu0/gyro/white" and so on), so that switching one off leaves the numbers of all others as they
// were.
#pragma once

#include <Eigen/Core>
#include <string>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/measurement.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Which of its sheet's effects an IMU shows.
struct ImuEffects {
  bool white_noise = true;
  bool bias_walk = true;
  bool turn_on_bias = true;
  bool scale_error = true;
  bool misalignment = true;
  bool saturation = true;
  bool quantisation = true;
};

/// `sheet` with those effects at zero that are not in `effects`.
ImuSheet KeepEffects(ImuSheet sheet, const ImuEffects& effects);

/// The errors of three axes.
class AxisTripleNoise {
 public:
  /// As ImuSheet has them.
  struct Sheet {
    double white = 0.0;
    double bias_walk = 0.0;
    double turn_on_bias = 0.0;
    double scale_error = 0.0;
    double misalignment = 0.0;
    double range = 0.0;
    double resolution = 0.0;
  };

  AxisTripleNoise(const Sheet& sheet, double rate_hz, std::uint64_t seed, const std::string& name);

  /// What is read of `truth`, by this sample's bias and noise; the bias then takes a step.
  Eigen::Vector3d Corrupt(const Eigen::Vector3d& truth);
  /// The bias of the next sample.
  const Eigen::Vector3d& bias() const { return bias_; }
  /// M: scale errors and misalignment.
  const Eigen::Matrix3d& response() const { return response_; }

 private:
  double white_sigma_;
  double walk_sigma_;
  double range_;
  double resolution_;
  RandomStream white_;
  RandomStream walk_;
  Eigen::Vector3d bias_;
  Eigen::Matrix3d response_;
};

/// Errors of the whole IMU; an all-zero sheet leaves samples untouched.
class ImuNoise {
 public:
  ImuNoise(const ImuSheet& sheet, std::uint64_t seed);

  ImuSample Corrupt(const ImuSample& truth);
  const Eigen::Vector3d& gyro_bias() const { return gyro_.bias(); }    ///< [rad/s]
  const Eigen::Vector3d& accel_bias() const { return accel_.bias(); }  ///< [m/s^2]
  const Eigen::Matrix3d& gyro_response() const { return gyro_.response(); }
  const Eigen::Matrix3d& accel_response() const { return accel_.response(); }

 private:
  AxisTripleNoise gyro_;
  AxisTripleNoise accel_;
};

}  // namespace drydock
