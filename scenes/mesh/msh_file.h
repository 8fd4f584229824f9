// MuJoCo's binary mesh format: four counts, then positions, normals, texture coordinates, faces.
#pragma once

#include <filesystem>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes {

/// Writes `mesh` as .msh (little-endian, single precision). InputError if the file cannot be
/// written.
void WriteMsh(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace drydock::scenes
