// What has grown and settled between the graves: weed, leaves, pebbles, rubble.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes/cemetery/graves.h"
#include "scenes/cemetery/site.h"
#include "scenes/model/model.h"

namespace drydock::scenes::cemetery {

// The columns of the picture `plants`, each a blade or a leaf with its root at the bottom.
inline constexpr int kPlantColumns = 16;
inline constexpr int kBladeColumns = 10;  ///< green; the others are dead leaves

/// Each patch is a part of its own, about a metre wide; what would reach into the way is low.
void AddGrowth(SceneModel& model, const Ground& ground, const std::vector<Grave>& graves,
               std::uint64_t seed);

}  // namespace drydock::scenes::cemetery
