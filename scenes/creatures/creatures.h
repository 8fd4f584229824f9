// What moves through the scenes: fish and a diver's arm, as meshes and pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/model/model.h"
#include "scenes/texture/texture_task.h"

namespace drydock::scenes::creatures {

/// A new version makes new files: count up whenever geometry or pictures change.
inline constexpr int kCreaturesVersion = 1;

/// A stiff part of a creature, by its files in the folder of all creatures. Coordinates and joints:
/// FishPart and MakeArm(); fish are one metre long.
struct CreaturePart {
  std::string mesh;     ///< "meshes/….msh"
  std::string texture;  ///< "textures/….png"
  double joint = 0.0;   ///< See FishPart [m].
};

/// The parts of every creature by its name, the first part first: the kinds of fish, `arm_left`,
/// `arm_right`.
std::map<std::string, std::vector<CreaturePart>> CreatureParts();

/// All parts, each a body of its own, where the creature's frame has them.
SceneModel BuildCreaturesModel();
/// Every picture that the parts refer to.
std::vector<TextureTask> TextureTasks();

/// Writes meshes/ and textures/ into `directory`, and a scene.xml to look at them in a viewer.
/// `texture_scale` multiplies the pictures' resolution; less than 1 is for tests.
void GenerateCreatures(std::uint64_t seed, const std::filesystem::path& directory,
                       double texture_scale = 1.0);

/// The folder with all creatures' files, generated into `cache`/scenes/ unless it is there already.
std::filesystem::path PrepareCreatures(const std::filesystem::path& cache);

}  // namespace drydock::scenes::creatures
