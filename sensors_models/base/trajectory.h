// A trajectory as every room of the house passes it on: poses of the body with their times.
#pragma once

#include <optional>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/base/time.h"

namespace drydock {

/// Where the body was: T_WI at time t.
struct StampedPose {
  Time t;
  Pose T_WI;
};

/// Strictly increasing in time.
using Trajectory = std::vector<StampedPose>;

/// Length of the polygon through the positions [m].
double PathLength(const Trajectory& trajectory);

/// The pose at `t` between two neighbours (linear in position, slerp in rotation), or nothing
/// outside the trajectory's span.
std::optional<Pose> Interpolate(const Trajectory& trajectory, Time t);

}  // namespace drydock
