// The scene `bus`: a school bus on a silty lake bed.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scenes/model/model.h"

namespace drydock::scenes::bus {

/// A new version makes new files: count up whenever geometry or pictures change.
inline constexpr int kBusVersion = 3;

/// All parts, in the world.
SceneModel BuildBusModel(std::uint64_t seed);

/// Writes scene.xml, meshes/ and textures/ into `directory`. `texture_scale` multiplies the
/// pictures' resolution; less than 1 is for tests.
void GenerateBus(std::uint64_t seed, const std::filesystem::path& directory,
                 double texture_scale = 1.0);

}  // namespace drydock::scenes::bus
