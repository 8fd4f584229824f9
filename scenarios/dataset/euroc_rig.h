// The rig of a recording in EuRoC's layout.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sensors_models/measurement/rig.h"

namespace drydock::dataset {

/// Takes messages about what is odd but can be read.
using Warn = std::function<void(const std::string& message)>;

/// Reads the sensor.yaml files below `mav0`: cam0, cam1 and imu0 must be there, sonar0 and
/// pressure0 may. Cameras must be `pinhole` with `radial-tangential` or `equidistant` distortion
/// and equally large images. The body of the rig is the IMU, wherever the recording's own body is.
/// Unknown keys are warned about; everything else that cannot be used is an InputError with file
/// and line.
///
/// Where the recording has our own rig.yaml, that is read, and must agree with the sensor.yaml
/// files to 1e-6: an edit of one alone is an error rather than a surprise.
Rig ReadEurocRig(const std::filesystem::path& mav0, const Warn& warn);

}  // namespace drydock::dataset
