#include "sim/sensors/sensors_config.h"

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

SensorsConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "s.yaml"), [](YamlReader& yaml) { return ReadSensors(yaml); });
}

TEST(SensorsConfig, EverythingIsOnByDefault) {
  const SensorsConfig config = Read("{}\n");
  EXPECT_TRUE(config.imu.enabled && config.imu.noise);
  EXPECT_TRUE(config.stereo.enabled && config.sonar.enabled && config.depth.enabled);
  EXPECT_FALSE(config.camera.depth_images);
  EXPECT_FALSE(config.camera.image.color);
}

TEST(SensorsConfig, SwitchesAreRead) {
  const SensorsConfig config = Read(
      "imu: {noise: false}\nsonar: {enabled: false}\ndepth: {latency_s: 0.25}\n"
      "stereo: {color: true, depth_images: true, exposure: 2.5}\n");
  EXPECT_FALSE(config.imu.noise);
  EXPECT_FALSE(config.sonar.enabled);
  EXPECT_EQ(config.depth.latency.ns, 250'000'000);
  EXPECT_TRUE(config.camera.image.color && config.camera.depth_images);
  EXPECT_EQ(config.camera.image.exposure, 2.5);
  EXPECT_TRUE(config.camera.image.noise && config.camera.image.vignetting);
  EXPECT_EQ(Read("stereo: {noise: false}\n").camera.image.exposure, std::nullopt);
  EXPECT_FALSE(Read("stereo: {noise: false}\n").camera.image.noise);
  EXPECT_FALSE(Read("stereo: {vignetting: false}\n").camera.image.vignetting);
}

TEST(SensorsConfig, APortIsReadWhereThereIsOne) {
  EXPECT_FALSE(Read("stereo: {}\n").camera.flat_port.enabled);
  const FlatPortConfig port = Read("stereo: {flat_port: {distance_m: 0.04}}\n").camera.flat_port;
  EXPECT_TRUE(port.enabled);
  EXPECT_EQ(port.distance_m, 0.04);
  EXPECT_THROW(Read("stereo: {flat_port: {glass: 3}}\n"), InputError);
}

TEST(SensorsConfig, EffectsAreOnByDefault) {
  const SensorsConfig config = Read("imu: {}\ndepth: {}\n");
  const ImuEffects& imu = config.imu_effects;
  EXPECT_TRUE(imu.white_noise && imu.bias_walk && imu.turn_on_bias && imu.scale_error);
  EXPECT_TRUE(imu.misalignment && imu.saturation && imu.quantisation);
  const PressureEffects& depth = config.depth_effects;
  EXPECT_TRUE(depth.white_noise && depth.offset && depth.lag && depth.quantisation);
}

/// How many effects are off.
int CountOff(const SensorsConfig& config) {
  const ImuEffects& imu = config.imu_effects;
  const PressureEffects& depth = config.depth_effects;
  int off = 0;
  for (const bool on : {imu.white_noise, imu.bias_walk, imu.turn_on_bias, imu.scale_error,
                        imu.misalignment, imu.saturation, imu.quantisation, depth.white_noise,
                        depth.offset, depth.lag, depth.quantisation}) {
    off += on ? 0 : 1;
  }
  return off;
}

TEST(SensorsConfig, EachEffectHasAKeyOfItsOwn) {
  const auto imu = [](const std::string& key) { return Read("imu: {" + key + ": false}\n"); };
  const auto depth = [](const std::string& key) { return Read("depth: {" + key + ": false}\n"); };
  EXPECT_FALSE(imu("white_noise").imu_effects.white_noise);
  EXPECT_FALSE(imu("bias_walk").imu_effects.bias_walk);
  EXPECT_FALSE(imu("turn_on_bias").imu_effects.turn_on_bias);
  EXPECT_FALSE(imu("scale_error").imu_effects.scale_error);
  EXPECT_FALSE(imu("misalignment").imu_effects.misalignment);
  EXPECT_FALSE(imu("saturation").imu_effects.saturation);
  EXPECT_FALSE(imu("quantisation").imu_effects.quantisation);
  for (const char* key : {"white_noise", "bias_walk", "turn_on_bias", "scale_error", "misalignment",
                          "saturation", "quantisation"}) {
    EXPECT_EQ(CountOff(imu(key)), 1) << key;
  }
  EXPECT_FALSE(depth("white_noise").depth_effects.white_noise);
  EXPECT_FALSE(depth("offset").depth_effects.offset);
  EXPECT_FALSE(depth("lag").depth_effects.lag);
  EXPECT_FALSE(depth("quantisation").depth_effects.quantisation);
  for (const char* key : {"white_noise", "offset", "lag", "quantisation"}) {
    EXPECT_EQ(CountOff(depth(key)), 1) << key;
  }
}

TEST(SensorsConfig, EffectsOfTheSonarAreRead) {
  const SonarEffects all = Read("{}\n").sonar_effects;
  EXPECT_TRUE(all.footprint && all.absorption && all.speckle && all.noise_floor);
  EXPECT_TRUE(all.dropouts && all.white_noise && all.quantisation);
  EXPECT_FALSE(all.profiles);
  const SonarEffects some =
      Read("sonar: {speckle: false, quantisation: false, profiles: true}\n").sonar_effects;
  EXPECT_TRUE(some.footprint && some.absorption && some.noise_floor && some.profiles);
  EXPECT_FALSE(some.speckle || some.quantisation);
  EXPECT_THROW(Read("sonar: {footprints: false}\n"), InputError);
}

TEST(SensorsConfig, EffectsThatAreOffAreZeroInTheSheet) {
  SonarSheet sheet;
  sheet.beam_width_rad = sheet.absorption_db_m = sheet.gain_absorption_db_m = 1.0;
  sheet.noise_floor = sheet.dropout_probability = sheet.range_noise_m = 1.0;
  sheet.speckle_looks = 1;
  const auto without = [&](bool SonarEffects::*effect) {
    SonarEffects effects;
    effects.*effect = false;
    return KeepEffects(sheet, effects);
  };
  EXPECT_EQ(without(&SonarEffects::footprint).beam_width_rad, 0.0);
  EXPECT_EQ(without(&SonarEffects::footprint).absorption_db_m, 1.0);
  EXPECT_EQ(without(&SonarEffects::absorption).absorption_db_m, 0.0);
  EXPECT_EQ(without(&SonarEffects::absorption).gain_absorption_db_m, 0.0);
  EXPECT_EQ(without(&SonarEffects::speckle).speckle_looks, 0);
  EXPECT_EQ(without(&SonarEffects::noise_floor).noise_floor, 0.0);
  EXPECT_EQ(without(&SonarEffects::dropouts).dropout_probability, 0.0);
  EXPECT_EQ(without(&SonarEffects::white_noise).range_noise_m, 0.0);
}

TEST(SensorsConfig, UnknownKeysAreRefused) {
  EXPECT_THROW(Read("lidar: {}\n"), InputError);
  EXPECT_THROW(Read("imu: {nose: false}\n"), InputError);
  EXPECT_THROW(Read("imu: {noise: no}\n"), InputError);
  EXPECT_THROW(Read("imu: {lag: false}\n"), InputError);
  EXPECT_THROW(Read("imu: {scale_error: 0}\n"), InputError);
  EXPECT_THROW(Read("sonar: {bias_walk: false}\n"), InputError);
  EXPECT_THROW(Read("depth: {latency_s: -1}\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
