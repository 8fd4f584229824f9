// Lamps that a vehicle or a diver carries, as a scenario describes them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sensors_models/base/yaml_reader.h"
#include "sim/optics/water_config.h"

namespace drydock::sim {

/// One lamp on the body. Its light falls off with the angle theta to its axis as
///   I(theta) = intensity exp(-k (1 - cos theta)),  k = ln 2 / (1 - cos(beam / 2)),
/// a bell on the sphere, and is nothing behind it.
struct LampConfig {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< In I.
  double yaw_deg = 0.0;                                  ///< Of the axis against x of I, left.
  double pitch_deg = 0.0;                                ///< Of the axis, down.
  double beam_deg = 90.0;        ///< Full angle at which half the intensity is left.
  double intensity_cd = 3000.0;  ///< On the axis, in green.
  double size_m = 0.06;          ///< Diameter of what shines: it softens shadows.
  Eigen::Vector3d color = Eigen::Vector3d::Ones();  ///< Red, green and blue against green.
};

/// Reads one mapping of the list `lamps` of a scenario.
LampConfig ReadLamp(YamlReader& yaml);

/// Illuminance of radiance 1's white card: full sun at the surface, which lies flat [lx].
inline constexpr double kFullSunLux = 1.0e5;

/// Unit vector along the lamp's axis, in I.
Eigen::Vector3d AxisOf(const LampConfig& lamp);

/// k of LampConfig.
double SharpnessOf(const LampConfig& lamp);

/// How far the light of lamps shows surfaces: beyond this range less than 1/4000 of what comes back
/// from 1 m returns, in any channel [m]; 0 without lamps.
double FarthestLampLight(const WaterConfig& water, const std::vector<LampConfig>& lamps);

}  // namespace drydock::sim
