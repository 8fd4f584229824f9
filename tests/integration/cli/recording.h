// A small recording in EuRoC's layout, whose odometry is known by hand.
#pragma once

#include <filesystem>

#include "sensors_models/measurement/rig.h"

namespace drydock::testing {

/// A rig with images of 32x24 px, IMU at 20 Hz, camera at 5 Hz, sonar at 10 Hz and pressure at 1
/// Hz.
Rig SmallRig();

/// Records a second below `target`/mav0. From 100 s on, the body glides level from (1, 2, 3) m, 2 m
/// below the surface: at 0.5 m/s along x, and along y from rest with 0.2 m/s^2, which beside
/// gravity is all that the IMU reads. Ideal sensors; the truth has a state at each IMU sample.
/// Frames arrive 40 ms late.
void RecordGlide(const std::filesystem::path& target);

}  // namespace drydock::testing
