// The scenes `cavern1` and `cavern2`: flooded caves in limestone, for lamps.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scenes/cave/plan.h"
#include "scenes/model/model.h"

namespace drydock::scenes::cave {

/// A new version makes new files: count up whenever geometry or pictures change.
inline constexpr int kCaveVersion = 1;

/// All parts, in the world: body `cave` is the rock, `sand` the floor; blocks, stones and dripstone
/// have bodies of their own. Another seed is another cave around the same route.
SceneModel BuildCaveModel(const CavePlan& plan, std::uint64_t seed);

/// Writes scene.xml, meshes/ and textures/ into `directory`. `texture_scale` multiplies the
/// pictures' resolution; less than 1 is for tests.
void GenerateCave(const CavePlan& plan, std::uint64_t seed, const std::filesystem::path& directory,
                  double texture_scale = 1.0);

}  // namespace drydock::scenes::cave
