#include "sim/optics/water_config.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/optics/jerlov.h"

namespace drydock::sim {

WaterConfig ReadWater(YamlReader& yaml) {
  WaterConfig water;
  water.jerlov_type = yaml.Choice("jerlov_type", JerlovTypeNames(), water.jerlov_type);
  water.visibility_m = yaml.Real("visibility_m", {0.0, 100.0}, water.visibility_m);
  water.surface_z_m = yaml.Real("surface_z_m", {-1000.0, 1000.0}, water.surface_z_m);
  water.veil = yaml.Real("veil", {0.0, 10.0}, water.veil);
  water.daylight = yaml.Real("daylight", {0.0, 10.0}, water.daylight);
  water.sun_share = yaml.Real("sun_share", {0.0, 1.0}, water.sun_share);
  water.sun_azimuth_deg = yaml.Real("sun_azimuth_deg", {-360.0, 360.0}, water.sun_azimuth_deg);
  water.sun_elevation_deg = yaml.Real("sun_elevation_deg", {5.0, 90.0}, water.sun_elevation_deg);
  water.shadows = yaml.Boolean("shadows", water.shadows);
  water.forward_scatter = yaml.Real("forward_scatter", {0.0, 1.0}, water.forward_scatter);
  water.forward_scatter_deg =
      yaml.Real("forward_scatter_deg", {0.01, 10.0}, water.forward_scatter_deg);
  yaml.OptionalMap("caustics",
                   [&](YamlReader& caustics) { water.caustics = ReadCaustics(caustics); });
  yaml.OptionalMap("snow", [&](YamlReader& snow) { water.snow = ReadMarineSnow(snow); });
  yaml.List("silt", [&](YamlReader& cloud) { water.silt.push_back(ReadSiltCloud(cloud)); });
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

Eigen::Array3d DaylightAt(const WaterConfig& water, double z_m) {
  const double depth = std::max(0.0, water.surface_z_m - z_m);
  return water.daylight * (-DiffuseAttenuation(water) * depth).exp();
}

double FarthestLight(const WaterConfig& water) {
  // Upwards light fades more slowly, see UnderwaterOptics.
  const Eigen::Array3d c = BeamAttenuation(water);
  const double slowest = (c - DiffuseAttenuation(water)).max(0.3 * c).minCoeff();
  return slowest > 0.0 ? std::log(4000.0) / slowest : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d DirectionToSun(const WaterConfig& water) {
  const double azimuth = water.sun_azimuth_deg * std::numbers::pi / 180.0;
  const double elevation = water.sun_elevation_deg * std::numbers::pi / 180.0;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

Eigen::Array3d ScatteringAlbedo(const WaterConfig& water) {
  const JerlovType& type = *FindJerlovType(water.jerlov_type);
  return type.scattering / type.BeamAttenuation();
}

}  // namespace drydock::sim
