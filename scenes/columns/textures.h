// The stones' and the sand's pictures: one each, for all copies.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes/texture/canvas.h"

namespace drydock::scenes::columns {

/// How to paint one texture; `scale` multiplies its resolution (1 for real, less for tests).
struct TextureTask {
  std::string name;
  std::function<cv::Mat3b(std::uint64_t seed, double scale)> paint;
};

/// Every texture that the parts refer to.
std::vector<TextureTask> TextureTasks();

}  // namespace drydock::scenes::columns
