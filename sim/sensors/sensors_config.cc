#include "sim/sensors/sensors_config.h"

namespace drydock::sim {
namespace {

void ReadSwitches(YamlReader& yaml, SensorSwitches& switches) {
  switches.enabled = yaml.Boolean("enabled", switches.enabled);
  switches.latency = Duration::FromSeconds(yaml.Real("latency_s", {0.0, 10.0}, 0.0));
}

/// `read_effects` reads what is this sensor's own.
template <typename ReadEffects>
void ReadNoisySensor(YamlReader& yaml, std::string_view key, SensorSwitches& switches,
                     ReadEffects read_effects) {
  yaml.OptionalMap(key, [&](YamlReader& sensor) {
    ReadSwitches(sensor, switches);
    switches.noise = sensor.Boolean("noise", switches.noise);
    read_effects(sensor);
  });
}

void ReadEffects(YamlReader& yaml, ImuEffects& effects) {
  effects.white_noise = yaml.Boolean("white_noise", effects.white_noise);
  effects.bias_walk = yaml.Boolean("bias_walk", effects.bias_walk);
  effects.turn_on_bias = yaml.Boolean("turn_on_bias", effects.turn_on_bias);
  effects.scale_error = yaml.Boolean("scale_error", effects.scale_error);
  effects.misalignment = yaml.Boolean("misalignment", effects.misalignment);
  effects.saturation = yaml.Boolean("saturation", effects.saturation);
  effects.quantisation = yaml.Boolean("quantisation", effects.quantisation);
}

void ReadEffects(YamlReader& yaml, PressureEffects& effects) {
  effects.white_noise = yaml.Boolean("white_noise", effects.white_noise);
  effects.offset = yaml.Boolean("offset", effects.offset);
  effects.lag = yaml.Boolean("lag", effects.lag);
  effects.quantisation = yaml.Boolean("quantisation", effects.quantisation);
}

}  // namespace

SensorsConfig ReadSensors(YamlReader& yaml) {
  SensorsConfig config;
  ReadNoisySensor(yaml, "imu", config.imu,
                  [&](YamlReader& imu) { ReadEffects(imu, config.imu_effects); });
  ReadNoisySensor(yaml, "sonar", config.sonar,
                  [&](YamlReader& sonar) { config.sonar_effects = ReadSonarEffects(sonar); });
  ReadNoisySensor(yaml, "depth", config.depth,
                  [&](YamlReader& depth) { ReadEffects(depth, config.depth_effects); });
  yaml.OptionalMap("stereo", [&](YamlReader& stereo) {
    ReadSwitches(stereo, config.stereo);
    config.camera.depth_images = stereo.Boolean("depth_images", config.camera.depth_images);
    config.camera.image = ReadImageSensor(stereo);
    stereo.OptionalMap("flat_port",
                       [&](YamlReader& port) { config.camera.flat_port = ReadFlatPort(port); });
  });
  return config;
}

}  // namespace drydock::sim
