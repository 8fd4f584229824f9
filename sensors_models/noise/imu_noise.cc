#include "sensors_models/noise/imu_noise.h"

#include <cmath>

namespace drydock {
namespace {

Eigen::Vector3d GaussianVector(RandomStream& stream) {
  // One after the other: the order of arguments of a call is not defined.
  const double x = stream.Gaussian();
  const double y = stream.Gaussian();
  const double z = stream.Gaussian();
  return {x, y, z};
}

}  // namespace

AxisTripleNoise::AxisTripleNoise(const Densities& densities, double rate_hz, std::uint64_t seed,
                                 const std::string& name)
    : white_sigma_(densities.white * std::sqrt(rate_hz)),
      walk_sigma_(densities.bias_walk / std::sqrt(rate_hz)),
      white_(seed, name + "/white"),
      walk_(seed, name + "/bias_walk") {
  RandomStream turn_on(seed, name + "/turn_on_bias");
  bias_ = densities.turn_on_bias * GaussianVector(turn_on);
}

Eigen::Vector3d AxisTripleNoise::Corrupt(const Eigen::Vector3d& truth) {
  const Eigen::Vector3d corrupted = truth + bias_ + white_sigma_ * GaussianVector(white_);
  bias_ += walk_sigma_ * GaussianVector(walk_);
  return corrupted;
}

ImuNoise::ImuNoise(const ImuSheet& sheet, std::uint64_t seed)
    : gyro_({sheet.gyro_noise_density, sheet.gyro_bias_walk, sheet.gyro_turn_on_bias},
            sheet.rate_hz, seed, "imu0/gyro"),
      accel_({sheet.accel_noise_density, sheet.accel_bias_walk, sheet.accel_turn_on_bias},
             sheet.rate_hz, seed, "imu0/accel") {}

ImuSample ImuNoise::Corrupt(const ImuSample& truth) {
  return {gyro_.Corrupt(truth.angular_rate), accel_.Corrupt(truth.specific_force)};
}

}  // namespace drydock
