#include "scenarios/compare/plan.h"

#include <fmt/format.h>

#include "scenarios/runner/scenario_yaml.h"
#include "scenarios/runner/start_estimator.h"

namespace drydock::compare {
namespace {

/// The scenario of a case, with nothing in it yet of who takes part.
YamlNode CaseFile(const Case& planned, const std::vector<std::string>& overrides) {
  LoadScenario(planned.scenario);  // The file must be valid by itself.
  YamlNode root = LoadWithBases(planned.scenario);
  SetAllYaml(root, planned.set);
  for (const std::string& assignment : overrides) SetYaml(root, assignment);
  // Those of the suite count: the scenario's must not decide which finished cases are kept.
  std::erase_if(root.members, [](const auto& member) { return member.first == "criteria"; });
  if (root.Find("estimator") == nullptr) {
    YamlNode estimator;
    estimator.kind = YamlNode::Kind::kMap;
    estimator.place = root.place;
    root.members.emplace_back("estimator", estimator);
  }
  return root;
}

Scenario ScenarioOf(YamlNode root, const std::string& name, const Entrant& entrant) {
  YamlNode& estimator = *root.Find("estimator");
  for (const auto& [key, value] : entrant.estimator.members) SetYaml(estimator, key, value);
  return ReadScenario(root, name);
}

}  // namespace

std::vector<PlannedCase> MakePlan(const Suite& suite, const std::vector<std::string>& overrides) {
  std::vector<PlannedCase> plan;
  for (const Case& planned : suite.cases) {
    const YamlNode root = CaseFile(planned, overrides);
    PlannedCase& added = plan.emplace_back(PlannedCase{planned.name, planned.seeds, {}});
    for (const Entrant& entrant : suite.entrants) {
      added.scenarios.push_back(ScenarioOf(root, planned.scenario.stem().string(), entrant));
      StartEstimator(added.scenarios.back(), NavState{});
    }
  }
  return plan;
}

Scenario WithSeed(Scenario scenario, std::uint64_t seed) {
  scenario.seed = seed;
  SetYaml(scenario.resolved, fmt::format("seed={}", seed));
  return scenario;
}

}  // namespace drydock::compare
