// The scene `cemetery`: rows of gravestones on the silt of a lake, in dim water.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scenes/model/model.h"

namespace drydock::scenes::cemetery {

/// A new version makes new files: count up whenever geometry or pictures change.
inline constexpr int kCemeteryVersion = 1;

/// All parts, in the world.
SceneModel BuildCemeteryModel(std::uint64_t seed);

/// Writes scene.xml, meshes/ and textures/ into `directory`. `texture_scale` multiplies the
/// pictures' resolution; less than 1 is for tests.
void GenerateCemetery(std::uint64_t seed, const std::filesystem::path& directory,
                      double texture_scale = 1.0);

}  // namespace drydock::scenes::cemetery
