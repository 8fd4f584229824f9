#include "scenes/creatures/creatures.h"

#include <utility>

#include <fmt/format.h>

#include "scenes/creatures/arm_shape.h"
#include "scenes/creatures/arm_texture.h"
#include "scenes/creatures/fish_shape.h"
#include "scenes/creatures/fish_textures.h"
#include "scenes/scene.h"

namespace drydock::scenes::creatures {
namespace {

/// A part with the creature it belongs to.
struct NamedPart {
  std::string creature;
  std::string name;
  std::string picture;
  FishPart part;
};

std::vector<NamedPart> EveryPart() {
  std::vector<NamedPart> parts;
  for (const FishShape& shape : FishShapes()) {
    int index = 0;
    for (FishPart& part : MakeFish(shape)) {
      parts.push_back(
          {shape.kind, fmt::format("{}_{}", shape.kind, index++), shape.kind, std::move(part)});
    }
  }
  parts.push_back({"arm_left", "arm_left", "arm", {MakeArm(Side::kLeft), 0.0}});
  parts.push_back({"arm_right", "arm_right", "arm", {MakeArm(Side::kRight), 0.0}});
  return parts;
}

}  // namespace

std::map<std::string, std::vector<CreaturePart>> CreatureParts() {
  std::map<std::string, std::vector<CreaturePart>> creatures;
  for (const NamedPart& part : EveryPart()) {
    creatures[part.creature].push_back({fmt::format("meshes/{}.msh", part.name),
                                        fmt::format("textures/{}.png", part.picture),
                                        part.part.joint});
  }
  return creatures;
}

SceneModel BuildCreaturesModel() {
  SceneModel model;
  for (NamedPart& part : EveryPart()) model.Add(part.name, part.picture, std::move(part.part.mesh));
  return model;
}

std::vector<TextureTask> TextureTasks() {
  std::vector<TextureTask> tasks = FishTextures();
  tasks.push_back(ArmTexture());
  return tasks;
}

void GenerateCreatures(std::uint64_t seed, const std::filesystem::path& directory,
                       double texture_scale) {
  PaintTextures(TextureTasks(), seed, texture_scale, directory / "textures");
  WriteMjcf(BuildCreaturesModel(), "creatures", directory);
}

std::filesystem::path PrepareCreatures(const std::filesystem::path& cache) {
  constexpr std::uint64_t kSeed = 1;  // Every dive meets the same creatures.
  const SceneEntry entry{"creatures", "fish and a diver's arm", kCreaturesVersion,
                         [](std::uint64_t seed, const std::filesystem::path& directory) {
                           GenerateCreatures(seed, directory);
                         }};
  return PrepareScene({entry}, entry.name, kSeed, cache).parent_path();
}

}  // namespace drydock::scenes::creatures
