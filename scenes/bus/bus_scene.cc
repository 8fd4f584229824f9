#include "scenes/bus/bus_scene.h"

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/clutter.h"
#include "scenes/bus/parts.h"
#include "scenes/bus/site.h"
#include "scenes/bus/textures.h"

namespace drydock::scenes::bus {

SceneModel BuildBusModel(std::uint64_t seed) {
  SceneModel model;
  AddBody(model, seed);
  AddNose(model);
  AddFittings(model);
  AddChassis(model);
  AddInterior(model, seed);
  AddSeats(model, seed);
  model.TransformFrom(0, BusPose());
  const LakeBed bed(seed);
  AddLakeBed(model, bed, seed);
  AddClutter(model, bed, Corridor(), seed);
  return model;
}

void GenerateBus(std::uint64_t seed, const std::filesystem::path& directory, double texture_scale) {
  PaintTextures(TextureTasks(), seed, texture_scale, directory / "textures");
  WriteMjcf(BuildBusModel(seed), "bus", directory);
}

}  // namespace drydock::scenes::bus
