#include "estimator/svin2/preintegration/imu_noise_model.h"

#include <cmath>

namespace drydock::svin2 {
namespace {

// How rate and force change in a body that looks about, within 1 to 4 s: on the bus dive the most
// lively axes do so by 0.044 rad/s and 0.43 m/s^2 (gravity, as the body pitches) a root of a
// second.
constexpr double kRateWalk = 0.04;  // [rad/s/sqrt(s)]
constexpr double kForceWalk = 0.4;  // [m/s^2/sqrt(s)]

double Response(double scale_error, double misalignment) {
  return std::hypot(scale_error, misalignment, misalignment);
}

}  // namespace

ImuNoiseModel NoiseModelOf(const ImuSheet& sheet, double inflation) {
  ImuNoiseModel noise;
  const auto inflate = [inflation](double& value, double of_sheet) {
    if (of_sheet > 0.0) value = inflation * of_sheet;
  };
  inflate(noise.gyro_noise_density, sheet.gyro_noise_density);
  inflate(noise.accel_noise_density, sheet.accel_noise_density);
  inflate(noise.gyro_bias_walk, sheet.gyro_bias_walk);
  inflate(noise.accel_bias_walk, sheet.accel_bias_walk);
  noise.gyro_bias_walk = std::hypot(
      noise.gyro_bias_walk, kRateWalk * Response(sheet.gyro_scale_error, sheet.gyro_misalignment));
  noise.accel_bias_walk =
      std::hypot(noise.accel_bias_walk,
                 kForceWalk * Response(sheet.accel_scale_error, sheet.accel_misalignment));
  noise.gyro_range = sheet.gyro_range;
  noise.accel_range = sheet.accel_range;
  return noise;
}

}  // namespace drydock::svin2
