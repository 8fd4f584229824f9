// From what a scenario says of its estimator to one that takes measurements.
#pragma once

#include <memory>

#include "scenarios/runner/scenario.h"

namespace drydock {

/// MakeEstimator, started from `truth` if the scenario says so. InputError with file and line for
/// an estimator that cannot start without.
std::unique_ptr<Estimator> StartEstimator(const Scenario& scenario, const NavState& truth);

}  // namespace drydock
