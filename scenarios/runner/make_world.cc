#include "scenarios/runner/make_world.h"

#include <filesystem>

#include "scenes/creatures/creatures.h"
#include "scenes/scene.h"
#include "sensors_models/base/resources.h"

namespace drydock {
namespace {

sim::Creatures LoadCreatures() {
  const std::filesystem::path folder = scenes::creatures::PrepareCreatures(CacheDirectory());
  sim::Creatures creatures;
  for (const auto& [name, parts] : scenes::creatures::CreatureParts()) {
    for (const scenes::creatures::CreaturePart& part : parts)
      creatures[name].push_back({folder / part.mesh, folder / part.texture, part.joint});
  }
  return creatures;
}

}  // namespace

sim::World MakeWorld(const Scenario& scenario) {
  const std::filesystem::path scene =
      scenes::PrepareScene(scenario.scene.name, scenario.scene.seed, CacheDirectory());
  if (scenario.moving.empty()) return sim::World(scene);
  return {scene, sim::MovingThings(scenario.moving, LoadCreatures(), scenario.seed)};
}

}  // namespace drydock
