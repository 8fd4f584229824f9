// One picture that a scene needs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scenes/texture/canvas.h"

namespace drydock::scenes {

/// How to paint one texture; `scale` multiplies its resolution (1 for real, less for tests).
struct TextureTask {
  std::string name;
  std::function<cv::Mat3b(std::uint64_t seed, double scale)> paint;
};

}  // namespace drydock::scenes
