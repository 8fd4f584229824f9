// The waves whose caustics play over what lies in shallow water, as a scenario describes them.
#pragma once

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

struct CausticsConfig {
  /// Root mean square of the water surface's slope, both axes together; 0 is a smooth surface: no
  /// caustics. A light breeze makes 0.08 to 0.12.
  double slope_rms = 0.0;
  /// The middle of the waves' lengths on a logarithmic scale, from half of it to twice [m]. Sets
  /// the mesh of the net and the depth at which it is sharpest.
  double wavelength_m = 0.7;
  double wind_azimuth_deg = 20.0;  ///< Whereto the waves run, in W, from x to y.
  /// The waves repeat at this spacing along x and y of W [m].
  double tile_m = 4.0;
};

/// Reads the `caustics` mapping of a scenario's water.
CausticsConfig ReadCaustics(YamlReader& yaml);

}  // namespace drydock::sim
