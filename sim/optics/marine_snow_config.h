// Flakes that float in the water, as a scenario describes them.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

struct MarineSnowConfig {
  double density_m3 = 44.0;  ///< Flakes in a cubic metre: 5000 within 3 m.
  /// Diameters [m]. Their number falls as size^-3 between the two, as Jackson et al. (Deep-Sea
  /// Research I 44, 1997) found for what images show.
  double size_min_m = 0.002;
  double size_max_m = 0.007;
  double range_m = 4.0;  ///< How far they are drawn; in the last fifth of it they fade away.
  double albedo = 0.5;   ///< Mean; a flake's own lies within a half of this around it.
  /// Of the water, in W, sinking included.
  Eigen::Vector3d current_m_s = {0.03, 0.02, -0.001};
  double wobble_m = 0.004;  ///< Amplitude of each flake's own swaying, in 3 to 8 s.
  /// The lens: its opening and the range at which it is sharp. Near flakes are blurred.
  double aperture_m = 0.0013;
  double focus_m = 2.0;
};

/// Reads the `snow` mapping of a scenario's water.
MarineSnowConfig ReadMarineSnow(YamlReader& yaml);

}  // namespace drydock::sim
