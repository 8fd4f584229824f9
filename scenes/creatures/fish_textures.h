// The fishes' coats: scales, bars, fins with rays, eyes.
#pragma once

#include <vector>

#include "scenes/texture/texture_task.h"

namespace drydock::scenes::creatures {

/// A picture for each kind of FishShapes(), by the same name, laid out as FishPicture.
std::vector<TextureTask> FishTextures();

}  // namespace drydock::scenes::creatures
