// What came out of a comparison.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/compare/finished.h"
#include "scenarios/compare/suite.h"

namespace drydock::compare {

/// One metric of one estimator in one case: a value a seed, nothing where it does not exist.
using SeedValues = std::vector<std::optional<double>>;

/// Of the values that exist; nothing if none does. The median of an even number of values is the
/// mean of the middle two.
std::optional<double> Summarize(Statistic statistic, const SeedValues& values);

struct CaseOutcome {
  std::string name;
  std::vector<std::uint64_t> seeds;
  std::vector<std::vector<Finished>> finished;  ///< By entrant, then by seed.
};

/// A criterion held against a comparison. It fails where a seed is without the metric: an estimator
/// that gives up in hard dives must not profit from that.
struct CriterionOutcome {
  SuiteCriterion criterion;
  std::string_view unit;
  std::optional<double> actual;
  bool passed = false;
};

struct Comparison {
  Suite suite;
  std::vector<CaseOutcome> cases;  ///< As in the suite.
  std::vector<CriterionOutcome> criteria;

  /// Every criterion is met; also true where there is none.
  bool Passed() const;
};

SeedValues ValuesOf(const std::vector<Finished>& finished, const score::MetricInfo& metric);

/// Holds the suite's criteria against `cases`.
std::vector<CriterionOutcome> JudgeAll(const Suite& suite, const std::vector<CaseOutcome>& cases);

}  // namespace drydock::compare
