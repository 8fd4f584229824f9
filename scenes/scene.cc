#include "scenes/scene.h"

#include <algorithm>

#include "scenes/bus/bus_scene.h"
#include "scenes/cave/cave_scene.h"
#include "scenes/cemetery/cemetery_scene.h"
#include "scenes/columns/columns_scene.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock::scenes {
namespace fs = std::filesystem;

std::vector<SceneEntry> Scenes() {
  return {
      {"bus", "a school bus on a silty lake bed, open at the back, that can be passed through",
       bus::kBusVersion,
       [](std::uint64_t seed, const fs::path& directory) { bus::GenerateBus(seed, directory); }},
      {"columns", "rows of standing stones on sand that look alike, to try place recognition",
       columns::kColumnsVersion,
       [](std::uint64_t seed, const fs::path& directory) {
         columns::GenerateColumns(seed, directory);
       }},
      {"cavern1", "a flooded cave: a ballroom in limestone around a pillar in fallen blocks",
       cave::kCaveVersion,
       [](std::uint64_t seed, const fs::path& directory) {
         cave::GenerateCave(cave::Cavern1Plan(), seed, directory);
       }},
      {"cavern2", "a flooded cave: two rooms in limestone and the passage between them",
       cave::kCaveVersion,
       [](std::uint64_t seed, const fs::path& directory) {
         cave::GenerateCave(cave::Cavern2Plan(), seed, directory);
       }},
      {"cemetery", "rows of gravestones, weed and leaves on the silt of a lake",
       cemetery::kCemeteryVersion,
       [](std::uint64_t seed, const fs::path& directory) {
         cemetery::GenerateCemetery(seed, directory);
       }},
  };
}

fs::path PrepareScene(const std::string& name, std::uint64_t seed, const fs::path& cache) {
  return PrepareScene(Scenes(), name, seed, cache);
}

fs::path PrepareScene(const std::vector<SceneEntry>& scenes, const std::string& name,
                      std::uint64_t seed, const fs::path& cache) {
  std::string known;
  for (const SceneEntry& entry : scenes) known += (known.empty() ? "" : ", ") + entry.name;
  const auto entry = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const SceneEntry& e) { return e.name == name; });
  RequireInput(entry != scenes.end(), "no scene \"{}\"; there are: {}", name, known);
  const fs::path folder =
      cache / "scenes" / fmt::format("{}-v{}-{}", entry->name, entry->version, seed);
  fs::path scene = folder / "scene.xml";
  if (fs::is_regular_file(scene)) return scene;
  AtomicDirectory directory(folder);
  entry->generate(seed, directory.path());
  directory.Commit(AtomicDirectory::IfExists::kKeepTheirs);
  return scene;
}

}  // namespace drydock::scenes
