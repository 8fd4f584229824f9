// A point of the map.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/time.h"

namespace drydock::svin2 {

struct TimedPoint {
  Time t;                                         ///< When it was met, or left the window.
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m], by the odometry of that time.
};

}  // namespace drydock::svin2
