// One picture that a scene needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenes/texture/canvas.h"

namespace drydock::scenes {

/// How to paint one texture; `scale` multiplies its resolution (1 for real, less for tests).
struct TextureTask {
  std::string name;
  std::function<cv::Mat3b(std::uint64_t seed, double scale)> paint;
};

/// Writes `directory`/NAME.png of each task; the folder is made if need be. InputError if a file
/// cannot be written.
void PaintTextures(const std::vector<TextureTask>& tasks, std::uint64_t seed, double scale,
                   const std::filesystem::path& directory);

}  // namespace drydock::scenes
