// The stones' and the sand's pictures: one each, for all copies.
#pragma once

#include <vector>

#include "scenes/texture/texture_task.h"

namespace drydock::scenes::columns {

/// Every texture that the parts refer to.
std::vector<TextureTask> TextureTasks();

}  // namespace drydock::scenes::columns
