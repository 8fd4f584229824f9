// SVIn2's options as people write them.
#pragma once

#include <memory>

#include "estimator/svin2/odometry/svin2.h"
#include "sensors_models/base/yaml_node.h"

namespace drydock::svin2 {

/// Reads `options` over `defaults`, strictly: InputError with file, line and key.
Svin2Config ReadSvin2Config(const YamlNode& options, const Svin2Config& defaults);

/// SVIn2 with its own front end.
std::unique_ptr<Estimator> MakeSvin2(const Rig& rig, const Svin2Config& config);

}  // namespace drydock::svin2
