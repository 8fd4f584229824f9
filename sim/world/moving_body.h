// What moves through a world beside the diver, as the world and the renderer see it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sensors_models/base/pose.h"

namespace drydock::sim {

/// A stiff body that is moved, not simulated.
struct MovingBody {
  std::string name;               ///< Unique among them.
  std::filesystem::path mesh;     ///< A .msh file, in B.
  std::filesystem::path texture;  ///< A .png file.
  double scale = 1.0;             ///< Of the mesh.
  float tint = 1.0F;              ///< Multiplies the texture.
};

/// T_WB of each moving body, in their order; nothing where one is not there.
using MovingPoses = std::vector<std::optional<Pose>>;

/// The files of a stiff part of a creature. Parts are in the frame of the straight creature, x
/// ahead, z up, fish one metre long.
struct CreaturePart {
  std::filesystem::path mesh;
  std::filesystem::path texture;
  double joint = 0.0;  ///< A part turns against the one ahead about the vertical at this x [m].
};

/// The parts of each creature by its name, from the head on: the kinds of fish, `arm_left` and
/// `arm_right`.
using Creatures = std::map<std::string, std::vector<CreaturePart>>;

}  // namespace drydock::sim
