// The scene `columns`: rows of standing stones on sand that look alike, to try place recognition.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scenes/model/model.h"

namespace drydock::scenes::columns {

/// A new version makes new files: count up whenever geometry or pictures change.
inline constexpr int kColumnsVersion = 1;

inline constexpr int kRows = 5;
inline constexpr int kStonesARow = 9;
inline constexpr double kRowSpacing = 3.4;    ///< The first row at y = kRowSpacing / 2 [m].
inline constexpr double kStoneSpacing = 2.1;  ///< [m]

/// All parts, in the world. The rows run along x; lanes of open water lie at y = 0, -kRowSpacing…
SceneModel BuildColumnsModel(std::uint64_t seed);

/// Writes scene.xml, meshes/ and textures/ into `directory`. `texture_scale` multiplies the
/// pictures' resolution; less than 1 is for tests.
void GenerateColumns(std::uint64_t seed, const std::filesystem::path& directory,
                     double texture_scale = 1.0);

}  // namespace drydock::scenes::columns
