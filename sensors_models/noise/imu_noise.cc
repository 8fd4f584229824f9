#include "sensors_models/noise/imu_noise.h"

#include <cmath>

#include "sensors_models/noise/digitise.h"

namespace drydock {
namespace {

Eigen::Vector3d GaussianVector(RandomStream& stream) {
  // One after the other: the order of arguments of a call is not defined.
  const double x = stream.Gaussian();
  const double y = stream.Gaussian();
  const double z = stream.Gaussian();
  return {x, y, z};
}

/// M of the header. The off-diagonal numbers are drawn row by row.
Eigen::Matrix3d DrawResponse(const AxisTripleNoise::Sheet& sheet, std::uint64_t seed,
                             const std::string& name) {
  RandomStream misalignment(seed, name + "/misalignment");
  Eigen::Matrix3d response = Eigen::Matrix3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      if (row != column) response(row, column) = sheet.misalignment * misalignment.Gaussian();
    }
  }
  RandomStream scale(seed, name + "/scale_error");
  const Eigen::Vector3d error = sheet.scale_error * GaussianVector(scale);
  return (Eigen::Vector3d::Ones() + error).asDiagonal() * response;
}

AxisTripleNoise::Sheet GyroSheet(const ImuSheet& sheet) {
  return {sheet.gyro_noise_density, sheet.gyro_bias_walk,    sheet.gyro_turn_on_bias,
          sheet.gyro_scale_error,   sheet.gyro_misalignment, sheet.gyro_range,
          sheet.gyro_resolution};
}

AxisTripleNoise::Sheet AccelSheet(const ImuSheet& sheet) {
  return {sheet.accel_noise_density, sheet.accel_bias_walk,    sheet.accel_turn_on_bias,
          sheet.accel_scale_error,   sheet.accel_misalignment, sheet.accel_range,
          sheet.accel_resolution};
}

}  // namespace

ImuSheet KeepEffects(ImuSheet sheet, const ImuEffects& effects) {
  if (!effects.white_noise) sheet.gyro_noise_density = sheet.accel_noise_density = 0.0;
  if (!effects.bias_walk) sheet.gyro_bias_walk = sheet.accel_bias_walk = 0.0;
  if (!effects.turn_on_bias) sheet.gyro_turn_on_bias = sheet.accel_turn_on_bias = 0.0;
  if (!effects.scale_error) sheet.gyro_scale_error = sheet.accel_scale_error = 0.0;
  if (!effects.misalignment) sheet.gyro_misalignment = sheet.accel_misalignment = 0.0;
  if (!effects.saturation) sheet.gyro_range = sheet.accel_range = 0.0;
  if (!effects.quantisation) sheet.gyro_resolution = sheet.accel_resolution = 0.0;
  return sheet;
}

AxisTripleNoise::AxisTripleNoise(const Sheet& sheet, double rate_hz, std::uint64_t seed,
                                 const std::string& name)
    : white_sigma_(sheet.white * std::sqrt(rate_hz)),
      walk_sigma_(sheet.bias_walk / std::sqrt(rate_hz)),
      range_(sheet.range),
      resolution_(sheet.resolution),
      white_(seed, name + "/white"),
      walk_(seed, name + "/bias_walk"),
      response_(DrawResponse(sheet, seed, name)) {
  RandomStream turn_on(seed, name + "/turn_on_bias");
  bias_ = sheet.turn_on_bias * GaussianVector(turn_on);
}

Eigen::Vector3d AxisTripleNoise::Corrupt(const Eigen::Vector3d& truth) {
  const Eigen::Vector3d analogue =
      response_ * truth + bias_ + white_sigma_ * GaussianVector(white_);
  bias_ += walk_sigma_ * GaussianVector(walk_);
  return analogue.unaryExpr([&](double axis) { return Digitise(axis, range_, resolution_); });
}

ImuNoise::ImuNoise(const ImuSheet& sheet, std::uint64_t seed)
    : gyro_(GyroSheet(sheet), sheet.rate_hz, seed, "imu0/gyro"),
      accel_(AccelSheet(sheet), sheet.rate_hz, seed, "imu0/accel") {}

ImuSample ImuNoise::Corrupt(const ImuSample& truth) {
  return {gyro_.Corrupt(truth.angular_rate), accel_.Corrupt(truth.specific_force)};
}

}  // namespace drydock
