#include "scenarios/compare/suite.h"

#include <set>

#include "estimator/registry/registry.h"
#include "sensors_models/base/check.h"

namespace drydock::compare {

std::string_view ToString(Statistic statistic) {
  switch (statistic) {
    case Statistic::kMedian:
      return "median";
    case Statistic::kMedianAbs:
      return "median_abs";
    case Statistic::kMean:
      return "mean";
    case Statistic::kMin:
      return "min";
    case Statistic::kMax:
      return "max";
  }
  return "";
}

Entrant PlainEntrant(const std::string& name) {
  YamlNode text;
  text.kind = YamlNode::Kind::kScalar;
  text.text = name;
  Entrant entrant{name, NoOptions()};
  entrant.estimator.members = {{"name", text}, {"options", NoOptions()}};
  return entrant;
}

Suite MakeSuite(const std::vector<std::string>& scenarios,
                const std::vector<std::string>& estimators, std::uint64_t first_seed,
                std::uint64_t seeds) {
  Suite suite;
  suite.name = "compare";
  suite.summary = "Estimators side by side";
  std::set<std::string> names;
  for (const std::string& file : scenarios) {
    Case added{std::filesystem::path(file).stem().string(), file, NoOptions(), {}};
    RequireInput(names.insert(added.name).second, "{}: another scenario is called {}, too", file,
                 added.name);
    for (std::uint64_t i = 0; i < seeds; ++i) added.seeds.push_back(first_seed + i);
    suite.cases.push_back(std::move(added));
  }
  std::set<std::string> labels;
  for (const std::string& name : estimators) {
    FindEstimator(name);
    RequireInput(labels.insert(name).second, "estimator {} is named twice", name);
    suite.entrants.push_back(PlainEntrant(name));
  }
  return suite;
}

}  // namespace drydock::compare
