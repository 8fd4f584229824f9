// Walls and ceiling as meshes: cut into chunks for culling, with places in the pictures.
#pragma once

#include <cstdint>

#include "scenes/cave/rock.h"
#include "scenes/model/model.h"

namespace drydock::scenes::cave {

inline constexpr double kRockTile = 5.12;  ///< One repetition of a wall's texture [m].

/// The rock's whole surface, closed, also where sand hides it; without texture coordinates.
Mesh RockSurface(const RockField& rock);

/// Chooses pictures for the parts of `surface`, cuts it into chunks and adds those to body `cave`;
/// leaves out what lies well below the sand.
void AddWalls(SceneModel& model, Mesh surface, const SandFloor& sand, std::uint64_t seed);

/// The same place in every texture, bent, so that no two repetitions look alike. `axis` is twice
/// the one that is looked along, plus one if against it. Bedding runs across the pictures of walls.
Eigen::Vector2d RockUv(const Eigen::Vector3d& p, int axis, std::uint64_t key);

}  // namespace drydock::scenes::cave
