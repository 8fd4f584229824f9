// Scenario files that build on others.
#pragma once

#include <filesystem>

#include "sensors_models/base/yaml_node.h"

namespace drydock {

/// Loads `path`; where it says `base: other.yaml`, lays it over that file (found beside it), and so
/// on. InputError for a chain that does not end. The result has no `base`.
YamlNode LoadWithBases(const std::filesystem::path& path);

}  // namespace drydock
