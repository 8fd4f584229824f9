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
  EXPECT_TRUE(config.image.noise && config.image.vignetting);
  EXPECT_EQ(Read("stereo: {noise: false}\n").image.exposure, std::nullopt);
  EXPECT_FALSE(Read("stereo: {noise: false}\n").image.noise);
  EXPECT_FALSE(Read("stereo: {vignetting: false}\n").image.vignetting);
}

TEST(SensorsConfig, UnknownKeysAreRefused) {
  EXPECT_THROW(Read("lidar: {}\n"), InputError);
  EXPECT_THROW(Read("imu: {nose: false}\n"), InputError);
  EXPECT_THROW(Read("imu: {noise: no}\n"), InputError);
  EXPECT_THROW(Read("depth: {latency_s: -1}\n"), InputError);
}

}  // namespace
}  // namespace drydock::sim
