#include "scenes/bus/textures.h"

namespace drydock::scenes::bus {

std::vector<TextureTask> TextureTasks() {
  std::vector<TextureTask> all;
  for (const auto& group :
       {BodyTextures(), InsideTextures(), BedTextures(), MaterialTextures(), DetailTextures()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace drydock::scenes::bus
