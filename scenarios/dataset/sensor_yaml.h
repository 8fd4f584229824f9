// EuRoC's sensor.yaml files, one a sensor, as text.
#pragma once

#include <array>
#include <string>

#include "sensors_models/measurement/rig.h"

namespace drydock::dataset {

/// The name of such a lens in EuRoC's sensor.yaml: "radial-tangential" or "equidistant".
std::string DistortionModel(LensModel lens);

std::string FormatBodyYaml(const Rig& rig);
/// `camera` is 0 (left) or 1 (right).
std::string FormatCameraYaml(const Rig& rig, std::size_t camera);
std::string FormatImuYaml(const Rig& rig);
std::string FormatSonarYaml(const Rig& rig);
std::string FormatPressureYaml(const Rig& rig);
std::string FormatTruthYaml();
/// Of the depth images of a camera.
std::string FormatDepthImageYaml(const Rig& rig, std::size_t camera);

}  // namespace drydock::dataset
