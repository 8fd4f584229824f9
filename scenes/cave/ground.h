// What lies on a cave's floor and hangs from its ceiling.
#pragma once

#include <cstdint>

#include "scenes/cave/rock.h"
#include "scenes/model/model.h"

namespace drydock::scenes::cave {

inline constexpr double kSandTile = 7.68;   ///< One repetition of the sand's texture [m].
inline constexpr double kBlockTile = 2.56;  ///< Of that of blocks and stones [m].

/// The sand as tiles that end inside the rock.
void AddSand(SceneModel& model, const RockField& rock, const SandFloor& sand, std::uint64_t seed);

/// Blocks that fell from the ceiling, in heaps and alone, and stones between them.
void AddBreakdown(SceneModel& model, const RockField& rock, const SandFloor& sand,
                  std::uint64_t seed);

/// Clusters of stalactites, and stalagmites below some of them.
void AddDripstone(SceneModel& model, const RockField& rock, const SandFloor& sand,
                  std::uint64_t seed);

}  // namespace drydock::scenes::cave
