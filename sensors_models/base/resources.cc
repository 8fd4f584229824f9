#include "sensors_models/base/resources.h"

#include <cstdlib>

namespace drydock {
namespace fs = std::filesystem;
namespace {

fs::path FromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? fs::path() : fs::path(value);
}

}  // namespace

fs::path DataDirectory() {
  if (const fs::path chosen = FromEnvironment("DRYDOCK_DATA"); !chosen.empty()) return chosen;
  const fs::path source = DRYDOCK_SOURCE_DIR;
  if (fs::is_directory(source / "scenarios")) return source;
  return DRYDOCK_INSTALL_DATA_DIR;
}

fs::path CacheDirectory() {
  if (const fs::path chosen = FromEnvironment("DRYDOCK_CACHE"); !chosen.empty()) return chosen;
  if (const fs::path xdg = FromEnvironment("XDG_CACHE_HOME"); !xdg.empty()) return xdg / "drydock";
  if (const fs::path home = FromEnvironment("HOME"); !home.empty())
    return home / ".cache" / "drydock";
  return fs::temp_directory_path() / "drydock-cache";
}

}  // namespace drydock
