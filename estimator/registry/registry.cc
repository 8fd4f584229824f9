#include "estimator/registry/registry.h"

#include <array>
#include <string>

#include "estimator/dead_reckoning/dead_reckoning.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock {
namespace {

std::unique_ptr<Estimator> MakeDeadReckoning(const Rig& rig, const YamlNode& options) {
  YamlReader(options).Finish();  // There is nothing to choose.
  return std::make_unique<DeadReckoning>(rig);
}

constexpr std::array kEstimators = {
    EstimatorEntry{"dead-reckoning", "IMU integrated from the true start, height held by pressure",
                   MakeDeadReckoning},
};

}  // namespace

std::span<const EstimatorEntry> Estimators() { return kEstimators; }

YamlNode NoOptions() {
  YamlNode options;
  options.kind = YamlNode::Kind::kMap;
  return options;
}

const EstimatorEntry& FindEstimator(std::string_view name) {
  std::string known;
  for (const EstimatorEntry& entry : kEstimators) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("estimator is {}, must be one of {}", name, known));
}

}  // namespace drydock
