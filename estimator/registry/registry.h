// Estimators by name. To add one: its folder, and a line in registry.cc.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "estimator/interface/estimator.h"
#include "sensors_models/base/yaml_node.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

struct EstimatorEntry {
  std::string_view name;
  std::string_view summary;  ///< One line.
  /// `options` is a mapping of what the estimator can be told; empty for its defaults. InputError
  /// with file and line for what it does not know.
  std::unique_ptr<Estimator> (*make)(const Rig& rig, const YamlNode& options);
};

std::span<const EstimatorEntry> Estimators();

/// Options that say nothing.
YamlNode NoOptions();

/// InputError that names the known ones if there is none of this name.
const EstimatorEntry& FindEstimator(std::string_view name);

}  // namespace drydock
