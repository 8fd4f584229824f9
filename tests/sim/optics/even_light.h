// Light and water that are the same everywhere, for tests of what floats.
#pragma once

#include <Eigen/Core>

#include "sim/optics/light_at.h"
#include "sim/optics/water_config.h"

namespace drydock::testing {

inline sim::LightAt EvenLight(float light) {
  return [light](const Eigen::Vector3d&) { return Eigen::Array3f::Constant(light).eval(); };
}

inline sim::WaterConfig WaterOf(double visibility_m) {
  sim::WaterConfig water;
  water.visibility_m = visibility_m;
  return water;
}

}  // namespace drydock::testing
