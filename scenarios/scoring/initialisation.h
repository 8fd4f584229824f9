// How good an estimator's start was.
#pragma once

#include <optional>

#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// Error of the scale with which an estimator set out [%], positive if it was too large: 100 (1/s -
/// 1) with s the scale of Sim(3) alignment of the odometry over the first 5 s of motion, counted
/// from its first pose at which the body has truly moved by 5 cm since the first pose of all.
/// Nothing if the odometry does not last that long, or the body moved by less than 0.5 m then.
std::optional<double> InitialScaleErrorPercent(const Trajectory& truth, const Trajectory& odometry);

}  // namespace drydock::score
