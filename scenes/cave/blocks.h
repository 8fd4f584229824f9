// Single things: blocks of broken rock, dripstone.
#pragma once

#include "scenes/mesh/mesh.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {

/// A block bounded by cracks and bedding, its middle at the origin, about `size` long [m].
Mesh MakeBlock(double size, RandomStream& random);

/// One repetition of the dripstone's texture along it [m]; round it once.
inline constexpr double kDripstoneTile = 1.6;

/// A stalactite of this length [m], its root at the origin and 0.3 m of it above.
Mesh MakeStalactite(double length, RandomStream& random);

}  // namespace drydock::scenes::cave
