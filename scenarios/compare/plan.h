// A suite worked out: every scenario that is to be run.
#pragma once

#include <string>
#include <vector>

#include "scenarios/compare/suite.h"
#include "scenarios/runner/scenario.h"

namespace drydock::compare {

/// A case and the scenario of each entrant in it, in the suite's order: they differ in `estimator`
/// alone.
struct PlannedCase {
  std::string name;
  std::vector<std::uint64_t> seeds;
  std::vector<Scenario> scenarios;
};

/// Makes every estimator of every case once, and starts it where that needs no truth. `overrides`
/// ("key.path=value") hold for all cases. InputError with file, line and key for what cannot be
/// used.
std::vector<PlannedCase> MakePlan(const Suite& suite, const std::vector<std::string>& overrides);

/// `scenario` with another seed.
Scenario WithSeed(Scenario scenario, std::uint64_t seed);

}  // namespace drydock::compare
