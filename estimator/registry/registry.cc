#include "estimator/registry/registry.h"

#include <array>
#include <string>

#include "estimator/dead_reckoning/dead_reckoning.h"
#include "sensors_models/base/check.h"

namespace drydock {
namespace {

template <typename T>
std::unique_ptr<Estimator> Make(const Rig& rig) {
  return std::make_unique<T>(rig);
}

constexpr std::array kEstimators = {
    EstimatorEntry{"dead-reckoning", "IMU integrated from the true start, height held by pressure",
                   Make<DeadReckoning>},
};

}  // namespace

std::span<const EstimatorEntry> Estimators() { return kEstimators; }

const EstimatorEntry& FindEstimator(std::string_view name) {
  std::string known;
  for (const EstimatorEntry& entry : kEstimators) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("estimator is {}, must be one of {}", name, known));
}

}  // namespace drydock
