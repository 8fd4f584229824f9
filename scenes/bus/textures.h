// The bus' pictures: painted in metres, aged, overgrown.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes/texture/canvas.h"

namespace drydock::scenes::bus {

/// How to paint one texture; `scale` multiplies its resolution (1 for real, less for tests).
struct TextureTask {
  std::string name;
  std::function<cv::Mat3b(std::uint64_t seed, double scale)> paint;
};

/// Every texture the bus' parts refer to.
std::vector<TextureTask> TextureTasks();

// By group; TextureTasks() is all of them.
std::vector<TextureTask> BodyTextures();
std::vector<TextureTask> InsideTextures();
std::vector<TextureTask> BedTextures();
std::vector<TextureTask> MaterialTextures();
std::vector<TextureTask> DetailTextures();

}  // namespace drydock::scenes::bus
