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
  PaintTextures(TextureTasks(), seed, texture_scale, directory / "textures");
  WriteMjcf(BuildCemeteryModel(seed), "cemetery", directory);
}

}  // namespace drydock::scenes::cemetery
