// Estimators by name. To add one: its folder, and a line in registry.cc.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "estimator/interface/estimator.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

struct EstimatorEntry {
  std::string_view name;
  std::string_view summary;  ///< One line.
  std::unique_ptr<Estimator> (*make)(const Rig& rig);
};

std::span<const EstimatorEntry> Estimators();

/// InputError that names the known ones if there is none of this name.
const EstimatorEntry& FindEstimator(std::string_view name);

}  // namespace drydock
