#include "scenes/cemetery/cemetery_scene.h"

#include <vector>

#include "scenes/cemetery/graves.h"
#include "scenes/cemetery/growth.h"
#include "scenes/cemetery/site.h"
#include "scenes/cemetery/textures.h"

namespace drydock::scenes::cemetery {

SceneModel BuildCemeteryModel(std::uint64_t seed) {
  SceneModel model;
  const Ground ground(seed);
  AddGround(model, ground);
  const std::vector<Grave> graves = LayOutGraves(seed);
  AddGraves(model, ground, graves, seed);
  AddRailings(model, ground, seed);
  AddGrowth(model, ground, graves, seed);
  return model;
}

void GenerateCemetery(std::uint64_t seed, const std::filesystem::path& directory,
                      double texture_scale) {
  std::filesystem::create_directories(directory / "textures");
  for (const TextureTask& task : TextureTasks()) {
    WritePng(task.paint(seed, texture_scale), directory / "textures" / (task.name + ".png"));
  }
  WriteMjcf(BuildCemeteryModel(seed), "cemetery", directory);
}

}  // namespace drydock::scenes::cemetery
