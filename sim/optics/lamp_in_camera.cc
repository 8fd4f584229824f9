#include "sim/optics/lamp_in_camera.h"

#include <algorithm>
#include <cmath>

namespace drydock::sim {

Eigen::Array3d LampInCamera::IlluminanceAt(const Eigen::Vector3d& p_C,
                                           const Eigen::Array3d& attenuation) const {
  const Eigen::Vector3d way = p_C - position_C;
  const double distance = std::max(way.norm(), kNearest);
  const double off_axis = way.dot(axis_C) / distance;
  if (off_axis <= 0.0) return Eigen::Array3d::Zero();
  return intensity * std::exp(sharpness * (off_axis - 1.0)) / (distance * distance) *
         (-attenuation * distance).exp();
}

LampInCamera SeenFrom(const LampConfig& lamp, const Pose& T_IC) {
  const Pose T_CI = T_IC.Inverse();
  return {T_CI * lamp.position_m, T_CI.q() * AxisOf(lamp), SharpnessOf(lamp),
          lamp.intensity_cd / kFullSunLux * lamp.color.array()};
}

}  // namespace drydock::sim
