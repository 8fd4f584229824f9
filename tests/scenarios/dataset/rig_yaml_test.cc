#include "scenarios/dataset/rig_yaml.h"

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::dataset {
namespace {

void ExpectSame(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.p(), b.p());
  EXPECT_EQ(a.q().coeffs(), b.q().coeffs());
}

void ExpectSame(const Rig& a, const Rig& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.stereo.rate_hz, b.stereo.rate_hz);
  for (std::size_t i = 0; i < 2; ++i) {
    ExpectSame(a.stereo.T_IC[i], b.stereo.T_IC[i]);
    EXPECT_EQ(a.stereo.cameras[i].fx, b.stereo.cameras[i].fx);
    EXPECT_EQ(a.stereo.cameras[i].fy, b.stereo.cameras[i].fy);
    EXPECT_EQ(a.stereo.cameras[i].cx, b.stereo.cameras[i].cx);
    EXPECT_EQ(a.stereo.cameras[i].cy, b.stereo.cameras[i].cy);
    EXPECT_EQ(a.stereo.cameras[i].width, b.stereo.cameras[i].width);
    EXPECT_EQ(a.stereo.cameras[i].height, b.stereo.cameras[i].height);
    EXPECT_EQ(a.stereo.cameras[i].lens, b.stereo.cameras[i].lens);
    EXPECT_EQ(a.stereo.cameras[i].distortion, b.stereo.cameras[i].distortion);
  }
  EXPECT_EQ(a.imu.rate_hz, b.imu.rate_hz);
  EXPECT_EQ(a.imu.gyro_noise_density, b.imu.gyro_noise_density);
  EXPECT_EQ(a.imu.accel_noise_density, b.imu.accel_noise_density);
  EXPECT_EQ(a.imu.gyro_bias_walk, b.imu.gyro_bias_walk);
  EXPECT_EQ(a.imu.accel_bias_walk, b.imu.accel_bias_walk);
  EXPECT_EQ(a.imu.gyro_turn_on_bias, b.imu.gyro_turn_on_bias);
  EXPECT_EQ(a.imu.accel_turn_on_bias, b.imu.accel_turn_on_bias);
  EXPECT_EQ(a.imu.gyro_scale_error, b.imu.gyro_scale_error);
  EXPECT_EQ(a.imu.accel_scale_error, b.imu.accel_scale_error);
  EXPECT_EQ(a.imu.gyro_misalignment, b.imu.gyro_misalignment);
  EXPECT_EQ(a.imu.accel_misalignment, b.imu.accel_misalignment);
  EXPECT_EQ(a.imu.gyro_range, b.imu.gyro_range);
  EXPECT_EQ(a.imu.accel_range, b.imu.accel_range);
  EXPECT_EQ(a.imu.gyro_resolution, b.imu.gyro_resolution);
  EXPECT_EQ(a.imu.accel_resolution, b.imu.accel_resolution);
  EXPECT_EQ(a.sonar.rate_hz, b.sonar.rate_hz);
  ExpectSame(a.sonar.T_IS, b.sonar.T_IS);
  EXPECT_EQ(a.sonar.step_rad, b.sonar.step_rad);
  EXPECT_EQ(a.sonar.min_range_m, b.sonar.min_range_m);
  EXPECT_EQ(a.sonar.max_range_m, b.sonar.max_range_m);
  EXPECT_EQ(a.sonar.range_noise_m, b.sonar.range_noise_m);
  EXPECT_EQ(a.sonar.beam_width_rad, b.sonar.beam_width_rad);
  EXPECT_EQ(a.sonar.bins, b.sonar.bins);
  EXPECT_EQ(a.sonar.pulse_length_s, b.sonar.pulse_length_s);
  EXPECT_EQ(a.sonar.incidence_exponent, b.sonar.incidence_exponent);
  EXPECT_EQ(a.sonar.absorption_db_m, b.sonar.absorption_db_m);
  EXPECT_EQ(a.sonar.gain_absorption_db_m, b.sonar.gain_absorption_db_m);
  EXPECT_EQ(a.sonar.speckle_looks, b.sonar.speckle_looks);
  EXPECT_EQ(a.sonar.noise_floor, b.sonar.noise_floor);
  EXPECT_EQ(a.sonar.dropout_probability, b.sonar.dropout_probability);
  EXPECT_EQ(a.sonar.intensity_floor, b.sonar.intensity_floor);
  EXPECT_EQ(a.depth.rate_hz, b.depth.rate_hz);
  EXPECT_EQ(a.depth.p_ID, b.depth.p_ID);
  EXPECT_EQ(a.depth.noise_m, b.depth.noise_m);
  EXPECT_EQ(a.depth.offset_m, b.depth.offset_m);
  EXPECT_EQ(a.depth.lag_s, b.depth.lag_s);
  EXPECT_EQ(a.depth.resolution_m, b.depth.resolution_m);
}

Rig ReadBack(const Rig& rig) { return ReadRig(ParseYaml(FormatRig(rig), "rig.yaml")); }

TEST(FormatRig, ComesBackToTheLastBit) {
  const Rig rig = LoadRig(FindRig("svin2_v3"));
  ExpectSame(ReadBack(rig), rig);
}

TEST(FormatRig, AlsoWhereItWasDisturbed) {
  RandomStream random(1, "rig");
  for (int i = 0; i < 100; ++i) {
    Rig rig = LoadRig(FindRig("svin2_v3"));
    rig.name = "a: \"nasty\" #name";
    for (Pose* pose : {&rig.stereo.T_IC[0], &rig.stereo.T_IC[1], &rig.sonar.T_IS}) {
      Vector6d delta;
      for (int k = 0; k < 6; ++k) delta(k) = 0.05 * random.Gaussian();
      *pose = pose->BoxPlus(delta);
    }
    rig.stereo.cameras[0].fx *= 1.0 + 0.01 * random.Gaussian();
    rig.imu.gyro_bias_walk *= 1.0 + 0.1 * random.Uniform();
    rig.sonar.step_rad = random.Uniform(0.1, 90.0) * M_PI / 180.0;
    for (double* value :
         {&rig.imu.gyro_scale_error, &rig.imu.accel_scale_error, &rig.imu.gyro_misalignment,
          &rig.imu.accel_misalignment, &rig.imu.gyro_range, &rig.imu.accel_range,
          &rig.imu.gyro_resolution, &rig.imu.accel_resolution, &rig.depth.offset_m,
          &rig.depth.lag_s, &rig.depth.resolution_m}) {
      *value *= 1.0 + 0.1 * random.Uniform();
    }
    rig.sonar.beam_width_rad = random.Uniform(0.1, 40.0) * M_PI / 180.0;
    rig.sonar.absorption_db_m = random.Uniform(0.0, 3.0);
    ExpectSame(ReadBack(rig), rig);
  }
}

TEST(FormatRig, NamesTheLens) {
  Rig rig = LoadRig(FindRig("svin2_v3"));
  rig.stereo.cameras[1].lens = LensModel::kEquidistant;
  rig.stereo.cameras[1].distortion = {-0.1, 7.0, 0.3, -1e-17};
  ExpectSame(ReadBack(rig), rig);
}

TEST(FormatRig, LeavesOutWhatTheRigDoesNotHave) {
  Rig rig = LoadRig(FindRig("svin2_v3"));
  rig.sonar = {};
  rig.depth = {};
  ExpectSame(ReadBack(rig), rig);
}

}  // namespace
}  // namespace drydock::dataset
