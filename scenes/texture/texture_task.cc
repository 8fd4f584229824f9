#include "scenes/texture/texture_task.h"

namespace drydock::scenes {

void PaintTextures(const std::vector<TextureTask>& tasks, std::uint64_t seed, double scale,
                   const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const TextureTask& task : tasks)
    WritePng(task.paint(seed, scale), directory / (task.name + ".png"));
}

}  // namespace drydock::scenes
