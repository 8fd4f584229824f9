#include "sim/sensors/sensors_config.h"

namespace drydock::sim {
namespace {

void ReadSwitches(YamlReader& yaml, SensorSwitches& switches) {
  switches.enabled = yaml.Boolean("enabled", switches.enabled);
  switches.latency = Duration::FromSeconds(yaml.Real("latency_s", {0.0, 10.0}, 0.0));
}

void ReadNoisySensor(YamlReader& yaml, std::string_view key, SensorSwitches& switches) {
  yaml.OptionalMap(key, [&](YamlReader& sensor) {
    ReadSwitches(sensor, switches);
    switches.noise = sensor.Boolean("noise", switches.noise);
  });
}

}  // namespace

SensorsConfig ReadSensors(YamlReader& yaml) {
  SensorsConfig config;
  ReadNoisySensor(yaml, "imu", config.imu);
  yaml.OptionalMap("sonar", [&](YamlReader& sonar) {
    ReadSwitches(sonar, config.sonar);
    config.sonar.noise = sonar.Boolean("noise", config.sonar.noise);
    config.sonar_effects = ReadSonarEffects(sonar);
  });
  ReadNoisySensor(yaml, "depth", config.depth);
  yaml.OptionalMap("stereo", [&](YamlReader& stereo) {
    ReadSwitches(stereo, config.stereo);
    config.depth_images = stereo.Boolean("depth_images", config.depth_images);
    config.image = ReadImageSensor(stereo);
  });
  return config;
}

}  // namespace drydock::sim
