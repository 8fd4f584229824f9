// What a run must reach to pass.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/scoring/metrics.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::score {

/// A metric and the values it may have, ends allowed; at least one bound is set.
struct Criterion {
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
};

/// A criterion held against a run. A metric that does not exist for the run fails.
struct CriterionResult {
  Criterion criterion;
  std::string_view unit;
  std::optional<double> actual;
  bool passed = false;
};

/// Reads `{metric: NAME, min: …, max: …}` (one bound may be missing). InputError with file and line
/// for an unknown metric, no bound, or min > max.
Criterion ReadCriterion(YamlReader& yaml);

/// InputError unless the metric is known, at least one bound is set, both are finite and min <=
/// max.
void ValidateCriterion(const Criterion& criterion);

CriterionResult Judge(const Criterion& criterion, const Metrics& metrics);

/// "<= 0.3", ">= 95", "from 0.5 to 2".
std::string DescribeBound(const Criterion& criterion);

}  // namespace drydock::score
