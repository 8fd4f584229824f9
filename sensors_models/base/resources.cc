#include "sensors_models/base/resources.h"

#include <cstdlib>
#include <system_error>

namespace drydock {
namespace fs = std::filesystem;
namespace {

fs::path FromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? fs::path() : fs::path(value);
}

/// share/drydock of the tree that the running program is installed in; empty if unknown.
fs::path BesideProgram() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path().parent_path() / "share" / "drydock";
}

}  // namespace

fs::path DataDirectory() {
  if (const fs::path chosen = FromEnvironment("DRYDOCK_DATA"); !chosen.empty()) return chosen;
  if (const fs::path beside = BesideProgram(); fs::is_directory(beside / "scenarios"))
    return beside;
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
