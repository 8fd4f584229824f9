#include "scenarios/runner/start_estimator.h"

#include "sensors_models/base/check.h"

namespace drydock {
namespace {

/// Where the scenario says, or ought to, whether the estimator knows its start.
std::string PlaceOfStart(const YamlNode& scenario) {
  const YamlNode* estimator = scenario.Find("estimator");
  if (estimator == nullptr) return scenario.place.ToString();
  const YamlNode* start = estimator->Find("start_from_truth");
  return (start == nullptr ? estimator : start)->place.ToString();
}

}  // namespace

std::unique_ptr<Estimator> StartEstimator(const Scenario& scenario, const NavState& truth) {
  std::unique_ptr<Estimator> estimator = MakeEstimator(scenario.estimator);
  if (scenario.estimator.start_from_truth) {
    estimator->Start(truth);
    return estimator;
  }
  try {
    estimator->Start(std::nullopt);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: estimator.start_from_truth is false: {}",
                                 PlaceOfStart(scenario.resolved), error.what()));
  }
  return estimator;
}

}  // namespace drydock
