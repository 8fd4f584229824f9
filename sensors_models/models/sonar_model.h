// Geometry of the rotating profiling sonar.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Where the head looks at the k-th ping [rad] in [0, 2 pi).
double SonarHeadAngle(const SonarSheet& sheet, std::int64_t ping);

/// Unit vector of the beam's axis, in S: (cos, sin, 0).
Eigen::Vector3d SonarBeam(double head_angle);

/// The point that an echo at `range` [m] came from, in S (paper eq. 4: r cos, r sin, 0).
Eigen::Vector3d SonarPoint(double head_angle, double range);

}  // namespace drydock
