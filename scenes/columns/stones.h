// The stones' few shapes. Every copy is cut and painted alike.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes::columns {

/// Meshes with the materials they are made of, standing at the origin on z = 0, facing -y.
using Stone = std::vector<std::pair<std::string, Mesh>>;

/// A round column of three drums on a square foot, 1.7 m high.
Stone MakeColumn();
/// A square pillar with a cap, 1.6 m high.
Stone MakePillar();
/// A slab with a round top and an inscription on both faces, 1.5 m high.
Stone MakeStele();

}  // namespace drydock::scenes::columns
