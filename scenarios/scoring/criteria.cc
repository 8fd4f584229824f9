#include "scenarios/scoring/criteria.h"

#include <cmath>

#include <fmt/ranges.h>

#include "sensors_models/base/check.h"

namespace drydock::score {
namespace {

std::string KnownNames() {
  std::vector<std::string_view> names;
  for (const MetricInfo& metric : AllMetrics()) names.push_back(metric.name);
  return fmt::format("one of {}", fmt::join(names, ", "));
}

}  // namespace

Criterion ReadCriterion(YamlReader& yaml) {
  Criterion criterion;
  criterion.metric = yaml.Text("metric");
  if (FindMetric(criterion.metric) == nullptr) yaml.Fail("metric", KnownNames());
  if (yaml.Has("min")) criterion.min = yaml.Real("min", Bounds::Any());
  if (yaml.Has("max")) criterion.max = yaml.Real("max", Bounds::Any());
  RequireInput(criterion.min || criterion.max, "{}: the criterion on {} needs 'min', 'max' or both",
               yaml.Place(), criterion.metric);
  if (criterion.min && criterion.max && *criterion.min > *criterion.max) {
    yaml.Fail("min", fmt::format("at most max, {}", *criterion.max));
  }
  // Known keys of the reader, also where they are missing: its messages list them.
  yaml.Skip("min");
  yaml.Skip("max");
  return criterion;
}

void ValidateCriterion(const Criterion& criterion) {
  RequireInput(FindMetric(criterion.metric) != nullptr, "criterion on '{}': must be {}",
               criterion.metric, KnownNames());
  RequireInput(criterion.min || criterion.max, "criterion on {}: needs a bound", criterion.metric);
  for (const auto& bound : {criterion.min, criterion.max}) {
    RequireInput(!bound || std::isfinite(*bound), "criterion on {}: a bound is {}, must be finite",
                 criterion.metric, bound.value_or(0.0));
  }
  RequireInput(!criterion.min || !criterion.max || *criterion.min <= *criterion.max,
               "criterion on {}: min {} is above max {}", criterion.metric,
               criterion.min.value_or(0.0), criterion.max.value_or(0.0));
}

CriterionResult Judge(const Criterion& criterion, const Metrics& metrics) {
  ValidateCriterion(criterion);
  const MetricInfo& info = *FindMetric(criterion.metric);
  CriterionResult result{criterion, info.unit, metrics.*info.value, false};
  result.passed = result.actual && (!criterion.min || *result.actual >= *criterion.min) &&
                  (!criterion.max || *result.actual <= *criterion.max);
  return result;
}

std::string DescribeBound(const Criterion& criterion) {
  if (criterion.min && criterion.max) {
    return fmt::format("from {} to {}", *criterion.min, *criterion.max);
  }
  return criterion.min ? fmt::format(">= {}", *criterion.min)
                       : fmt::format("<= {}", criterion.max.value_or(0.0));
}

}  // namespace drydock::score
