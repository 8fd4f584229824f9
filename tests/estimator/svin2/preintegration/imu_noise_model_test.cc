#include "estimator/svin2/preintegration/imu_noise_model.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

TEST(ImuNoiseModel, InflatesWhatTheSheetHas) {
  ImuSheet sheet;
  sheet.gyro_noise_density = 1e-4;
  sheet.accel_bias_walk = 3e-5;
  sheet.accel_range = 49.0;
  const ImuNoiseModel noise = NoiseModelOf(sheet, 2.0);
  EXPECT_DOUBLE_EQ(noise.gyro_noise_density, 2e-4);
  EXPECT_DOUBLE_EQ(noise.accel_bias_walk, 6e-5);
  EXPECT_EQ(noise.accel_range, 49.0);
  EXPECT_EQ(noise.accel_noise_density, ImuNoiseModel{}.accel_noise_density);
  EXPECT_EQ(noise.gyro_bias_walk, ImuNoiseModel{}.gyro_bias_walk);
}

TEST(ImuNoiseModel, ScaleErrorsAndMisalignmentLetTheBiasesWalk) {
  ImuSheet sheet;
  sheet.gyro_bias_walk = sheet.accel_bias_walk = 1e-9;
  // m = 3e-3.
  sheet.gyro_scale_error = sheet.accel_scale_error = 1e-3;
  sheet.gyro_misalignment = sheet.accel_misalignment = 2e-3;
  const ImuNoiseModel noise = NoiseModelOf(sheet, 1.0);
  EXPECT_NEAR(noise.gyro_bias_walk, 0.04 * 3e-3, 1e-9);
  EXPECT_NEAR(noise.accel_bias_walk, 0.4 * 3e-3, 1e-9);
}

}  // namespace
}  // namespace drydock::svin2
