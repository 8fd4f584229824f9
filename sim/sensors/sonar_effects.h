// Which effects of the sonar a scenario wants.
#pragma once

#include "sensors_models/base/yaml_reader.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::sim {

/// How strong an effect is, the rig's sheet says; what it does not mention is off anyway.
struct SonarEffects {
  bool footprint = true;     ///< The whole cone; off: a ray along its axis.
  bool absorption = true;    ///< By the water, and the gain against it.
  bool speckle = true;       ///< In each bin.
  bool noise_floor = true;   ///< The receiver's noise.
  bool dropouts = true;      ///< Pings lost as a whole.
  bool white_noise = true;   ///< On all ranges of a ping alike.
  bool quantisation = true;  ///< Ranges are middles of bins, amplitudes have 8 bits. Off: a range
                             ///< is the mean range of the echoes in its bin.
  bool profiles = false;     ///< Pings carry their echo profile.
};

/// Reads them from the `sonar` mapping of a scenario's sensors.
SonarEffects ReadSonarEffects(YamlReader& yaml);

/// The sheet with the values of effects that are off set to zero.
SonarSheet KeepEffects(const SonarSheet& sheet, const SonarEffects& effects);

}  // namespace drydock::sim
