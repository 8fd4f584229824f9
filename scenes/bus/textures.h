// The bus' pictures: painted in metres, aged, overgrown.
#pragma once

#include <vector>

#include "scenes/texture/texture_task.h"

namespace drydock::scenes::bus {

/// Every texture the bus' parts refer to.
std::vector<TextureTask> TextureTasks();

// By group; TextureTasks() is all of them.
std::vector<TextureTask> BodyTextures();
std::vector<TextureTask> InsideTextures();
std::vector<TextureTask> BedTextures();
std::vector<TextureTask> MaterialTextures();
std::vector<TextureTask> DetailTextures();

}  // namespace drydock::scenes::bus
