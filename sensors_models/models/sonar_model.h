// Geometry of the rotating profiling sonar.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Where the head looks at the k-th ping [rad] in [0, 2 pi).
double SonarHeadAngle(const SonarSheet& sheet, std::int64_t ping);

/// Unit vector of the beam's axis, in S: (cos, sin, 0).
Eigen::Vector3d SonarBeam(double head_angle);

/// The point that an echo at `range` [m] came from, in S (paper eq. 4: r cos, r sin, 0).
Eigen::Vector3d SonarPoint(double head_angle, double range);

/// Length of a range bin [m]. The sheet has bins.
double SonarBinLength(const SonarSheet& sheet);

/// Middle of a range bin, counted from 0 at the head [m].
double SonarBinCentre(const SonarSheet& sheet, std::size_t bin);

/// Standard deviation of a ping's range [m] on a face that the beam meets squarely: the sheet's
/// white noise, and the rounding to the middle of a bin (length / sqrt(12)).
double SonarRangeSigma(const SonarSheet& sheet);

}  // namespace drydock
