// What is compared: dives, estimators, and what they must reach.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/scoring/criteria.h"
#include "sensors_models/base/yaml_node.h"

namespace drydock::compare {

/// A dive that is simulated once a seed.
struct Case {
  std::string name;
  std::filesystem::path scenario;
  YamlNode set;  ///< Keys of the scenario by their paths: {water.visibility_m: 6}.
  std::vector<std::uint64_t> seeds;
};

/// An estimator with its options, as often as one likes under different labels.
struct Entrant {
  std::string label;
  /// What takes the place of the same keys of the scenario's `estimator`: name and options, and
  /// where they are said rig, rig_set and start_from_truth.
  YamlNode estimator;
};

/// How the values over the seeds become one.
enum class Statistic { kMedian, kMedianAbs, kMean, kMin, kMax };

/// "median", "median_abs", "mean", "min" or "max".
std::string_view ToString(Statistic statistic);

/// A bound on a statistic of one estimator in one case.
struct SuiteCriterion {
  std::string case_name;
  std::string label;  ///< The entrant's.
  Statistic statistic = Statistic::kMedian;
  score::Criterion criterion;
};

struct Suite {
  std::string name;  ///< The file's without .yaml.
  std::string summary;
  std::vector<Case> cases;
  std::vector<Entrant> entrants;
  std::vector<SuiteCriterion> criteria;
};

/// Cases of the scenario files by themselves, each with seeds `first_seed` and the `seeds` - 1 that
/// follow, and registered estimators without options. InputError for two files of one name, or an
/// estimator that is unknown or named twice.
Suite MakeSuite(const std::vector<std::string>& scenarios,
                const std::vector<std::string>& estimators, std::uint64_t first_seed,
                std::uint64_t seeds);

/// An entrant of a registered estimator's name, without options.
Entrant PlainEntrant(const std::string& name);

}  // namespace drydock::compare
