// Which sensors a scenario uses, and with what errors.
#pragma once

#include "sensors_models/base/time.h"
#include "sensors_models/base/yaml_reader.h"
#include "sim/optics/image_sensor.h"
#include "sim/sensors/sonar_effects.h"

namespace drydock::sim {

/// Switches of one sensor; the rig says what it can do.
struct SensorSwitches {
  bool enabled = true;
  bool noise = true;  ///< Off: exactly the truth. Images have no noise as yet.
  Duration latency;   ///< From measurement to arrival.
};

struct SensorsConfig {
  SensorSwitches imu;
  SensorSwitches stereo;
  SensorSwitches sonar;
  SonarEffects sonar_effects;
  SensorSwitches depth;
  bool depth_images = false;  ///< True depth beside each image.
  ImageSensorConfig image;
};

/// Reads the `sensors` mapping of a scenario.
SensorsConfig ReadSensors(YamlReader& yaml);

}  // namespace drydock::sim
