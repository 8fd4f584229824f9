// Trajectories in TUM's format: a line `t tx ty tz qx qy qz qw` a pose, time in seconds, position
// in metres, the body in the world.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sensors_models/base/trajectory.h"

namespace drydock::dataset {

/// Reads strictly: eight numbers within ±1e9 a line between blanks, times within ±4.6e9 s and
/// increasing, quaternions of length 1 to within 1e-3 (they are normalised). Empty lines and lines
/// that begin with '#' are skipped; CRLF is tolerated. Times are read to the nanosecond. InputError
/// "file:line: …" else. An empty file is an empty trajectory.
Trajectory ParseTum(std::string_view text, const std::string& file);
Trajectory ReadTum(const std::filesystem::path& path);

/// Seconds with nine digits, everything else with 17, so that reading gives the same doubles;
/// single spaces, none at the end.
std::string FormatTum(const Trajectory& trajectory);
/// Complete or not at all.
void WriteTum(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace drydock::dataset
