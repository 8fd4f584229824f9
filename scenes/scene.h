// Scenes by name: generated once, then kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace drydock::scenes {

struct SceneEntry {
  std::string name;
  std::string summary;  ///< one line
  int version = 1;      ///< of the generator; another version is another folder
  /// Writes scene.xml and what it refers to into a folder that exists.
  std::function<void(std::uint64_t seed, const std::filesystem::path& directory)> generate;
};

/// Every scene there is. A new one is a folder and a line here.
std::vector<SceneEntry> Scenes();

/// The MJCF file of scene `name`, generated into `cache`/scenes/ unless it is there already. The
/// same seed gives the same files. InputError if there is no such scene, naming those there are.
std::filesystem::path PrepareScene(const std::string& name, std::uint64_t seed,
                                   const std::filesystem::path& cache);
/// The same from a table of one's own.
std::filesystem::path PrepareScene(const std::vector<SceneEntry>& scenes, const std::string& name,
                                   std::uint64_t seed, const std::filesystem::path& cache);

}  // namespace drydock::scenes
