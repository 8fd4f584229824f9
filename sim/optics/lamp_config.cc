#include "sim/optics/lamp_config.h"

#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

LampConfig ReadLamp(YamlReader& yaml) {
  LampConfig lamp;
  lamp.position_m = yaml.Vector3("position_m", {-10.0, 10.0});
  lamp.yaw_deg = yaml.Real("yaw_deg", {-180.0, 180.0}, lamp.yaw_deg);
  lamp.pitch_deg = yaml.Real("pitch_deg", {-90.0, 90.0}, lamp.pitch_deg);
  lamp.beam_deg = yaml.Real("beam_deg", {1.0, 170.0}, lamp.beam_deg);
  lamp.intensity_cd = yaml.Real("intensity_cd", {0.0, 1e7}, lamp.intensity_cd);
  lamp.size_m = yaml.Real("size_m", {0.0, 1.0}, lamp.size_m);
  lamp.color = yaml.Vector3("color", {0.0, 10.0}, lamp.color);
  return lamp;
}

Eigen::Vector3d AxisOf(const LampConfig& lamp) {
  const double yaw = lamp.yaw_deg * kDegree, pitch = lamp.pitch_deg * kDegree;
  return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), -std::sin(pitch)};
}

double SharpnessOf(const LampConfig& lamp) {
  return std::numbers::ln2 / (1.0 - std::cos(0.5 * lamp.beam_deg * kDegree));
}

double FarthestLampLight(const WaterConfig& water, const std::vector<LampConfig>& lamps) {
  if (lamps.empty()) return 0.0;
  // exp(-2 c r) / r^2 against its value at 1 m, solved by steps as fine as it matters.
  const double c = BeamAttenuation(water).minCoeff();
  double range = 1.0;
  while (2.0 * c * (range - 1.0) + 2.0 * std::log(range) < std::log(4000.0)) range += 0.05;
  return range;
}

}  // namespace drydock::sim
