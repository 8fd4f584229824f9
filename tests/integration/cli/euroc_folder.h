// A recording as the makers of EuRoC would have written it.
#pragma once

#include <filesystem>

#include "sensors_models/measurement/rig.h"

namespace drydock::testing {

/// Rewrites our recording below `target`/mav0 to the letter of a real one: what only we have goes
/// (rig.yaml, arrivals.csv, sonar, pressure); what they have besides is there (body.yaml, leica0,
/// vicon0, pointcloud0, comments in the sheets, lines that end in \r\n); the ground truth is poses
/// alone. Its IMU is mounted as theirs: x up, y right, z forward.
void MakeLikeEuroc(const std::filesystem::path& target);

}  // namespace drydock::testing
