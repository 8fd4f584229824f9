// Which sensors a scenario uses, and with what errors.
#pragma once

#include "sensors_models/base/time.h"
#include "sensors_models/base/yaml_reader.h"
#include "sensors_models/noise/imu_noise.h"
#include "sensors_models/noise/pressure_noise.h"
#include "sim/optics/image_sensor.h"
#include "sim/render/flat_port.h"
#include "sim/sensors/sonar_effects.h"

namespace drydock::sim {

/// Switches of one sensor; the rig says what it can do.
struct SensorSwitches {
  bool enabled = true;
  bool noise = true;  ///< Off: exactly the truth.
  Duration latency;   ///< From measurement to arrival.
};

/// What a scenario says of the camera; the rig says what it can do.
struct StereoCameraConfig {
  ImageSensorConfig image;
  FlatPortConfig flat_port;   ///< Before both eyes.
  bool depth_images = false;  ///< True depth beside each image.
};

struct SensorsConfig {
  SensorSwitches imu;
  SensorSwitches stereo;
  SensorSwitches sonar;
  SonarEffects sonar_effects;
  SensorSwitches depth;
  ImuEffects imu_effects;         ///< Of an IMU with noise; all on by default.
  PressureEffects depth_effects;  ///< Of a pressure sensor with noise; all on by default.
  StereoCameraConfig camera;
};

/// Reads the `sensors` mapping of a scenario.
SensorsConfig ReadSensors(YamlReader& yaml);

}  // namespace drydock::sim
