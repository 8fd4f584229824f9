// A rig whose cameras can be computed with.
#pragma once

#include <filesystem>
#include <string>

#include "sensors_models/base/yaml_node.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// The rig of a file with some of its keys changed ({stereo.rate_hz: 10}: see SetAllYaml), read as
/// LoadRig does, and RequireUsable for each camera, with file, line and key.
Rig LoadUsableRig(const std::filesystem::path& path, const YamlNode& changes = {});

/// InputError that begins with `place` if the distortion folds over inside the image: then several
/// points of the world meet in one pixel, and pixels have no ray. Looked for along the image's
/// border and on a grid of some thousand pixels. Pixels at the border of an equidistant lens that
/// does not fold may look to the side or back: they have no ray either, and nobody uses them.
void RequireUsable(const CameraIntrinsics& camera, const std::string& place);

}  // namespace drydock
