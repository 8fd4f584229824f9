// Water and daylight, as a scenario describes them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "sensors_models/base/yaml_reader.h"
#include "sim/optics/caustics_config.h"
#include "sim/optics/marine_snow_config.h"
#include "sim/optics/silt_config.h"

namespace drydock::sim {

struct WaterConfig {
  std::string jerlov_type = "III";  ///< Sets the colour of the water.
  /// Distance at which contrast has fallen to 2 % in the green channel [m] (Koschmieder): c = 3.912
  /// / V there; the other channels keep their ratio to green. 0 is perfectly clear water: no haze,
  /// no attenuation.
  double visibility_m = 12.0;
  double surface_z_m = 6.0;  ///< Height of the water's surface, in W.
  /// Radiance of infinitely deep water, seen horizontally, as a share of what a white card that
  /// faces upwards sends out, per unit of scattering albedo b/c.
  double veil = 0.15;
  /// At the surface, as a share of full sun; 0.001 is deep dusk.
  double daylight = 1.0;
  double sun_share =
      0.45;  ///< Of the daylight that comes straight from the sun; the rest is diffuse.
  /// Where the sunlight comes from, under water.
  double sun_azimuth_deg = 140.0;  ///< In W, from x to y.
  double sun_elevation_deg = 62.0;
  bool shadows = true;  ///< What stands in the light's way keeps it off, surfaces and water alike.
  /// Share of the scattering that bends light by so little that it arrives as blur; 0 for none.
  double forward_scatter = 0.3;
  double forward_scatter_deg = 0.6;  ///< Standard deviation of that bend, along each image axis.
  CausticsConfig caustics;
  std::optional<MarineSnowConfig> snow;
  std::vector<SiltCloud> silt;
};

/// Reads the `water` mapping of a scenario.
WaterConfig ReadWater(YamlReader& yaml);

/// Beam attenuation c per channel (red, green, blue) [1/m]; zero in perfectly clear water.
Eigen::Array3d BeamAttenuation(const WaterConfig& water);

/// How fast daylight fades with depth, Kd, per channel [1/m]: that of the water's type, whatever
/// the visibility, since turbidity scatters light rather than swallowing it; zero in perfectly
/// clear water.
Eigen::Array3d DiffuseAttenuation(const WaterConfig& water);

/// Daylight at `z_m` [m, in W] per channel, as a share of full sun at the surface.
Eigen::Array3d DaylightAt(const WaterConfig& water, double z_m);

/// How far light from a surface is seen at all: beyond this range less than 1/4000 of it arrives in
/// any channel [m]; infinite in perfectly clear water.
double FarthestLight(const WaterConfig& water);

/// Unit vector towards the sun, in W.
Eigen::Vector3d DirectionToSun(const WaterConfig& water);

/// b/c per channel: the share of the light lost from a beam that is scattered rather than absorbed.
Eigen::Array3d ScatteringAlbedo(const WaterConfig& water);

}  // namespace drydock::sim
