#include "scenes/cave/cave_scene.h"

#include "scenes/cave/ground.h"
#include "scenes/cave/rock.h"
#include "scenes/cave/textures.h"
#include "scenes/cave/walls.h"

namespace drydock::scenes::cave {

SceneModel BuildCaveModel(const CavePlan& plan, std::uint64_t seed) {
  SceneModel model;
  const RockField rock(plan, seed);
  const SandFloor sand(rock, seed);
  AddWalls(model, RockSurface(rock), sand, seed);
  AddSand(model, rock, sand, seed);
  AddBreakdown(model, rock, sand, seed);
  AddDripstone(model, rock, sand, seed);
  return model;
}

void GenerateCave(const CavePlan& plan, std::uint64_t seed, const std::filesystem::path& directory,
                  double texture_scale) {
  PaintTextures(TextureTasks(), seed, texture_scale, directory / "textures");
  WriteMjcf(BuildCaveModel(plan, seed), plan.name, directory);
}

}  // namespace drydock::scenes::cave
