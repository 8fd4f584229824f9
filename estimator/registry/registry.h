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
  /// Options, in YAML, of one that has to keep up with a robot.
  std::string_view on_robot;
};

std::span<const EstimatorEntry> Estimators();

/// Options that say nothing.
YamlNode NoOptions();

/// `options`, and what they leave unsaid as it should be for an estimator that has to keep up with
/// a robot.
YamlNode OnRobot(const EstimatorEntry& entry, const YamlNode& options);

/// InputError that names the known ones if there is none of this name.
const EstimatorEntry& FindEstimator(std::string_view name);

}  // namespace drydock
