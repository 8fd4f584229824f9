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
  EXPECT_FALSE(config.depth_images);
  EXPECT_FALSE(config.image.color);
}

TEST(SensorsConfig, SwitchesAreRead) {
  const SensorsConfig config = Read(
      "imu: {noise: false}\nsonar: {enabled: false}\ndepth: {latency_s: 0.25}\n"
      "stereo: {color: true, depth_images: true, exposure: 2.5}\n");
  EXPECT_FALSE(config.imu.noise);
  EXPECT_FALSE(config.sonar.enabled);
  EXPECT_EQ(config.depth.latency.ns, 250'000'000);
  EXPECT_TRUE(config.image.color && config.depth_images);
  EXPECT_EQ(config.image.exposure, 2.5);
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
    return WithEffects(sheet, effects);
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
  EXPECT_THROW(Read("depth: {latency_s: -1}\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
