// The pictures of limestone, its crusts, broken rock, dripstone and sand.
#pragma once

#include <vector>

#include "scenes/texture/texture_task.h"

namespace drydock::scenes::cave {

/// Every texture that the parts refer to.
std::vector<TextureTask> TextureTasks();

}  // namespace drydock::scenes::cave
