// The gravestones' few shapes. Copies differ by size, wear, inscription, a broken corner.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/mesh/mesh.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cemetery {

/// Meshes with the materials they are made of, standing at the origin on z = 0, facing -y.
using Object = std::vector<std::pair<std::string, Mesh>>;

enum class Shape { kRoundTop, kGabled, kCross, kPillow, kObelisk };
inline constexpr int kShapes = 5;

/// A stone of about 0.4 (pillow) to 1.3 m (obelisk) with one inscription of the atlas; it is of the
/// inscription's stone.
Object MakeStone(Shape shape, int inscription, RandomStream& random);

/// An urn, 0.3 m high.
Object MakeUrn(RandomStream& random);
/// A low frame of stone around a grave: from y = 0 to -length, `width` wide.
Object MakeKerb(double width, double length, RandomStream& random);
/// A piece of a broken slab, lying flat, about `size` wide.
Object MakeShard(double size, RandomStream& random);
/// A fence of iron bars along x, `height` high, from x = 0 to `length`.
Object MakeRailing(double length, double height, RandomStream& random);

}  // namespace drydock::scenes::cemetery
