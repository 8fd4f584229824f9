// What a real IMU adds to the truth.
#pragma once

#include <string>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/measurement.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// White noise and a bias that walks from a random start, for three axes. Discrete: noise density /
/// sqrt(dt) a sample, walk density * sqrt(dt) a step.
class AxisTripleNoise {
 public:
  /// Densities as ImuSheet has them; `turn_on_bias` is the standard deviation of the first bias.
  struct Densities {
    double white = 0.0;
    double bias_walk = 0.0;
    double turn_on_bias = 0.0;
  };

  AxisTripleNoise(const Densities& densities, double rate_hz, std::uint64_t seed,
                  const std::string& name);

  /// `truth` with this sample's bias and noise; the bias then takes a step.
  Eigen::Vector3d Corrupt(const Eigen::Vector3d& truth);
  /// The bias of the next sample.
  const Eigen::Vector3d& bias() const { return bias_; }

 private:
  double white_sigma_;
  double walk_sigma_;
  RandomStream white_;
  RandomStream walk_;
  Eigen::Vector3d bias_;
};

/// Noise of the whole IMU; an all-zero sheet leaves samples untouched.
class ImuNoise {
 public:
  ImuNoise(const ImuSheet& sheet, std::uint64_t seed);

  ImuSample Corrupt(const ImuSample& truth);
  const Eigen::Vector3d& gyro_bias() const { return gyro_.bias(); }    ///< [rad/s]
  const Eigen::Vector3d& accel_bias() const { return accel_.bias(); }  ///< [m/s^2]

 private:
  AxisTripleNoise gyro_;
  AxisTripleNoise accel_;
};

}  // namespace drydock
