#include "scenarios/compare/summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sensors_models/base/check.h"

namespace drydock::compare {
namespace {

/// Of at least one value.
double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

const std::vector<Finished>& FinishedOf(const Suite& suite, const std::vector<CaseOutcome>& cases,
                                        const SuiteCriterion& criterion) {
  for (const CaseOutcome& outcome : cases) {
    if (outcome.name != criterion.case_name) continue;
    for (std::size_t i = 0; i < suite.entrants.size(); ++i) {
      if (suite.entrants[i].label == criterion.label) return outcome.finished[i];
    }
  }
  Check(false, "no {} in case {}", criterion.label, criterion.case_name);
  return cases.front().finished.front();
}

CriterionOutcome JudgeOne(const SuiteCriterion& criterion, const std::vector<Finished>& finished) {
  const score::MetricInfo& metric = *score::FindMetric(criterion.criterion.metric);
  const SeedValues values = ValuesOf(finished, metric);
  score::Metrics metrics;
  if (std::all_of(values.begin(), values.end(), [](const auto& v) { return v.has_value(); }))
    metrics.*metric.value = Summarize(criterion.statistic, values);
  const score::CriterionResult result = score::Judge(criterion.criterion, metrics);
  return {criterion, result.unit, result.actual, result.passed};
}

}  // namespace

std::optional<double> Summarize(Statistic statistic, const SeedValues& values) {
  std::vector<double> present;
  for (const auto& value : values) {
    if (value) present.push_back(statistic == Statistic::kMedianAbs ? std::abs(*value) : *value);
  }
  if (present.empty()) return std::nullopt;
  switch (statistic) {
    case Statistic::kMedian:
    case Statistic::kMedianAbs:
      return Median(std::move(present));
    case Statistic::kMean:
      return std::accumulate(present.begin(), present.end(), 0.0) /
             static_cast<double>(present.size());
    case Statistic::kMin:
      return *std::min_element(present.begin(), present.end());
    case Statistic::kMax:
      return *std::max_element(present.begin(), present.end());
  }
  return std::nullopt;
}

bool Comparison::Passed() const {
  return std::all_of(criteria.begin(), criteria.end(),
                     [](const CriterionOutcome& outcome) { return outcome.passed; });
}

SeedValues ValuesOf(const std::vector<Finished>& finished, const score::MetricInfo& metric) {
  SeedValues values;
  values.reserve(finished.size());
  for (const Finished& one : finished) values.push_back(one.scorecard.metrics.*metric.value);
  return values;
}

std::vector<CriterionOutcome> JudgeAll(const Suite& suite, const std::vector<CaseOutcome>& cases) {
  std::vector<CriterionOutcome> outcomes;
  outcomes.reserve(suite.criteria.size());
  for (const SuiteCriterion& criterion : suite.criteria)
    outcomes.push_back(JudgeOne(criterion, FinishedOf(suite, cases, criterion)));
  return outcomes;
}

}  // namespace drydock::compare
