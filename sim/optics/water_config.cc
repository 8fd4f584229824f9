#include "sim/optics/water_config.h"

#include "sim/optics/jerlov.h"

namespace drydock::sim {

WaterConfig ReadWater(YamlReader& yaml) {
  WaterConfig water;
  water.jerlov_type = yaml.Choice("jerlov_type", JerlovTypeNames(), water.jerlov_type);
  water.visibility_m = yaml.Real("visibility_m", {0.0, 100.0}, water.visibility_m);
  water.surface_z_m = yaml.Real("surface_z_m", {-1000.0, 1000.0}, water.surface_z_m);
  water.veil = yaml.Real("veil", {0.0, 10.0}, water.veil);
  water.sun_share = yaml.Real("sun_share", {0.0, 1.0}, water.sun_share);
  water.sun_azimuth_deg = yaml.Real("sun_azimuth_deg", {-360.0, 360.0}, water.sun_azimuth_deg);
  water.sun_elevation_deg = yaml.Real("sun_elevation_deg", {5.0, 90.0}, water.sun_elevation_deg);
  return water;
}

Eigen::Array3d BeamAttenuation(const WaterConfig& water) {
  if (water.visibility_m == 0.0) return Eigen::Array3d::Zero();
  constexpr double kLnFifty = 3.912;  // -ln(0.02)
  const Eigen::Array3d of_type = FindJerlovType(water.jerlov_type)->BeamAttenuation();
  return of_type / of_type[1] * kLnFifty / water.visibility_m;
}

Eigen::Array3d DiffuseAttenuation(const WaterConfig& water) {
  if (water.visibility_m == 0.0) return Eigen::Array3d::Zero();
  return FindJerlovType(water.jerlov_type)->DiffuseAttenuation();
}

Eigen::Array3d ScatteringAlbedo(const WaterConfig& water) {
  const JerlovType& type = *FindJerlovType(water.jerlov_type);
  return type.scattering / type.BeamAttenuation();
}

}  // namespace drydock::sim
