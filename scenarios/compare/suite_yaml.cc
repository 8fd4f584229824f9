#include "scenarios/compare/suite_yaml.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/ranges.h>

#include "estimator/registry/registry.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::compare {
namespace {

constexpr Bounds kSeed{0, 1e15};
constexpr Statistic kStatistics[] = {Statistic::kMedian, Statistic::kMedianAbs, Statistic::kMean,
                                     Statistic::kMin, Statistic::kMax};

/// The mapping under `key` with its paths spelled out as mappings; an empty one where it is
/// missing.
YamlNode ReadPaths(YamlReader& yaml, std::string_view key) {
  YamlNode tree = NoOptions();
  if (const YamlNode* paths = yaml.OptionalSubtree(key)) {
    tree.place = paths->place;
    SetAllYaml(tree, *paths);
  }
  return tree;
}

std::vector<std::uint64_t> ReadSeeds(YamlReader& yaml) {
  std::vector<std::uint64_t> seeds;
  for (const double seed : yaml.Reals("seeds", kSeed)) {
    const auto whole = static_cast<std::uint64_t>(seed);
    if (static_cast<double>(whole) != seed) yaml.Fail("seeds", "a list of whole numbers");
    if (std::find(seeds.begin(), seeds.end(), whole) != seeds.end())
      yaml.Fail("seeds", fmt::format("a list of different numbers; {} stands twice", whole));
    seeds.push_back(whole);
  }
  if (seeds.empty()) yaml.Fail("seeds", "a list of at least one");
  return seeds;
}

Case ReadCase(YamlReader& yaml, const std::filesystem::path& folder,
              const std::vector<std::uint64_t>& seeds) {
  Case read;
  read.name = yaml.Text("name");
  read.scenario = (folder / yaml.Text("scenario")).lexically_normal();
  if (!std::filesystem::is_regular_file(read.scenario))
    yaml.Fail("scenario", fmt::format("a file that is there; {} is not", read.scenario.string()));
  read.set = NoOptions();
  if (const YamlNode* set = yaml.OptionalSubtree("set")) read.set = *set;
  if (const YamlNode* duration = yaml.Value("duration_s"))
    read.set.members.emplace_back("duration_s", *duration);
  yaml.Skip("seeds");
  read.seeds = yaml.Has("seeds") ? ReadSeeds(yaml) : seeds;
  if (read.seeds.empty())
    RequireInput(false, "{}: case {} has no seeds, nor has the suite", yaml.Place(), read.name);
  return read;
}

Entrant ReadEntrant(YamlReader& yaml) {
  Entrant entrant;
  entrant.label = yaml.Text("label");
  entrant.estimator = NoOptions();
  yaml.Text("name");  // Must be there; which names are known is for the scenario's reader to say.
  for (const char* key : {"name", "rig", "start_from_truth"}) {
    if (const YamlNode* value = yaml.Value(key))
      entrant.estimator.members.emplace_back(key, *value);
  }
  entrant.estimator.members.emplace_back("options", ReadPaths(yaml, "options"));
  if (const YamlNode* changes = yaml.OptionalSubtree("rig_set"))
    entrant.estimator.members.emplace_back("rig_set", *changes);
  return entrant;
}

/// One of `known` or a list of them.
std::vector<std::string> ReadNames(YamlReader& yaml, std::string_view key,
                                   const std::vector<std::string>& known) {
  const std::string allowed = fmt::format("one or a list of {}", fmt::join(known, ", "));
  const YamlNode* value = yaml.Value(key);
  if (value == nullptr) RequireInput(false, "{}: the key '{}' is missing", yaml.Place(), key);
  std::vector<std::string> names;
  const bool list = value->kind == YamlNode::Kind::kList;
  for (const YamlNode& item : list ? value->items : std::vector<YamlNode>{*value}) {
    if (item.kind != YamlNode::Kind::kScalar ||
        std::find(known.begin(), known.end(), item.text) == known.end())
      yaml.Fail(key, allowed);
    names.push_back(item.text);
  }
  if (names.empty()) yaml.Fail(key, allowed);
  return names;
}

Statistic ReadStatistic(YamlReader& yaml) {
  std::vector<std::string> names;
  for (const Statistic statistic : kStatistics) names.emplace_back(ToString(statistic));
  const std::string chosen = yaml.Choice("statistic", names, "median");
  return kStatistics[std::find(names.begin(), names.end(), chosen) - names.begin()];
}

void ReadCriteria(YamlReader& yaml, Suite& suite) {
  std::vector<std::string> cases;
  cases.reserve(suite.cases.size());
  for (const Case& known : suite.cases) cases.push_back(known.name);
  std::vector<std::string> labels;
  labels.reserve(suite.entrants.size());
  for (const Entrant& known : suite.entrants) labels.push_back(known.label);
  SuiteCriterion read;
  read.statistic = ReadStatistic(yaml);
  for (const std::string& case_name : ReadNames(yaml, "case", cases)) {
    for (const std::string& label : ReadNames(yaml, "estimator", labels)) {
      read.case_name = case_name;
      read.label = label;
      read.criterion = score::ReadCriterion(yaml);
      suite.criteria.push_back(read);
    }
  }
}

template <typename T>
void RequireNew(YamlReader& yaml, std::string_view key, const std::vector<T>& earlier,
                std::string T::*name, const std::string& added) {
  for (const T& other : earlier) {
    if (other.*name == added) yaml.Fail(key, "a name that does not stand twice");
  }
}

}  // namespace

Suite LoadSuite(const std::filesystem::path& path) {
  return ReadYaml(LoadYaml(path), [&](YamlReader& yaml) {
    Suite suite;
    suite.name = path.stem().string();
    suite.summary = yaml.Text("summary");
    yaml.Skip("seeds");
    const auto seeds = yaml.Has("seeds") ? ReadSeeds(yaml) : std::vector<std::uint64_t>{};
    yaml.List("cases", [&](YamlReader& item) {
      Case read = ReadCase(item, path.parent_path(), seeds);
      RequireNew(item, "name", suite.cases, &Case::name, read.name);
      suite.cases.push_back(std::move(read));
    });
    yaml.List("estimators", [&](YamlReader& item) {
      Entrant read = ReadEntrant(item);
      RequireNew(item, "label", suite.entrants, &Entrant::label, read.label);
      suite.entrants.push_back(std::move(read));
    });
    if (suite.cases.empty()) yaml.Fail("cases", "a list of at least one");
    if (suite.entrants.empty()) yaml.Fail("estimators", "a list of at least one");
    yaml.List("criteria", [&](YamlReader& item) { ReadCriteria(item, suite); });
    return suite;
  });
}

}  // namespace drydock::compare
