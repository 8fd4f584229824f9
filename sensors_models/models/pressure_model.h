// What a pressure sensor reads as depth.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose.h"

namespace drydock {

/// Depth [m, positive downwards] of the pressure port at `p_ID` [m, in I] below the surface at
/// height `surface_z` [m, in W].
double DepthBelowSurface(const Pose& T_WI, const Eigen::Vector3d& p_ID, double surface_z);

}  // namespace drydock
