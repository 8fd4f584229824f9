#include "scenarios/runner/scenario.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/runner/scenario_yaml.h"
#include "scenes/scene.h"
#include "sensors_models/base/yaml_reader.h"
#include "sensors_models/models/usable_rig.h"

namespace drydock {
namespace {

constexpr Bounds kSeed{0, 1e15};

SceneChoice ReadScene(YamlReader& yaml) {
  SceneChoice scene;
  scene.name = yaml.Text("name");
  std::vector<std::string> known;
  for (const scenes::SceneEntry& entry : scenes::Scenes()) known.push_back(entry.name);
  if (std::find(known.begin(), known.end(), scene.name) == known.end())
    yaml.Fail("name", fmt::format("one of {}", fmt::join(known, ", ")));
  scene.seed = static_cast<std::uint64_t>(yaml.Integer("seed", kSeed, 1));
  return scene;
}

/// The name of a rig that is there. A file of one's own is given by its path.
std::string ReadRigName(YamlReader& yaml, std::string_view key) {
  std::string name = yaml.Text(key);
  if (name.ends_with(".yaml")) {
    if (!std::filesystem::exists(name)) yaml.Fail(key, "a file that is there");
    return name;
  }
  const std::vector<std::string> known = KnownRigs();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    yaml.Fail(key, fmt::format("one of {}, or a path that ends in .yaml", fmt::join(known, ", ")));
  }
  return name;
}

EstimatorChoice ReadEstimator(YamlReader& yaml) {
  EstimatorChoice estimator;
  std::vector<std::string> known;
  for (const EstimatorEntry& entry : Estimators()) known.emplace_back(entry.name);
  estimator.name = yaml.Choice("name", known, estimator.name);
  if (yaml.Has("rig")) estimator.rig = ReadRigName(yaml, "rig");
  yaml.Skip("rig");  // Also where it is missing: messages list it among the known keys.
  if (const YamlNode* changes = yaml.OptionalSubtree("rig_set")) estimator.rig_set = *changes;
  estimator.start_from_truth = yaml.Boolean("start_from_truth", estimator.start_from_truth);
  if (const YamlNode* options = yaml.OptionalSubtree("options")) estimator.options = *options;
  return estimator;
}

}  // namespace

Scenario ReadScenario(const YamlNode& root, const std::string& name) {
  Scenario scenario = ReadYaml(root, [&](YamlReader& yaml) {
    Scenario read;
    read.summary = yaml.Text("summary");
    yaml.Map("scene", [&](YamlReader& scene) { read.scene = ReadScene(scene); });
    read.rig = ReadRigName(yaml, "rig");
    yaml.OptionalMap("water", [&](YamlReader& water) { read.water = sim::ReadWater(water); });
    yaml.List("lamps", [&](YamlReader& lamp) { read.lamps.push_back(sim::ReadLamp(lamp)); });
    yaml.OptionalMap("sensors",
                     [&](YamlReader& sensors) { read.sensors = sim::ReadSensors(sensors); });
    yaml.Map("motion", [&](YamlReader& motion) { read.motion = sim::ReadMotion(motion); });
    yaml.List("moving",
              [&](YamlReader& thing) { read.moving.push_back(sim::ReadMovingThing(thing)); });
    yaml.OptionalMap("estimator",
                     [&](YamlReader& estimator) { read.estimator = ReadEstimator(estimator); });
    read.seed = static_cast<std::uint64_t>(yaml.Integer("seed", kSeed, 1));
    if (yaml.Has("duration_s")) read.duration_s = yaml.Real("duration_s", {0.1, 1e5});
    yaml.List("criteria", [&](YamlReader& criterion) {
      read.criteria.push_back(score::ReadCriterion(criterion));
    });
    return read;
  });
  if (scenario.estimator.rig.empty()) scenario.estimator.rig = scenario.rig;
  scenario.name = name;
  scenario.resolved = root;
  MakeEstimator(scenario.estimator);  // Only the estimator itself can tell whether it understands.
  return scenario;
}

std::unique_ptr<Estimator> MakeEstimator(const EstimatorChoice& choice) {
  return FindEstimator(choice.name)
      .make(LoadUsableRig(FindRig(choice.rig), choice.rig_set), choice.options);
}

Scenario WithEstimatorOnRobot(const Scenario& scenario) {
  const EstimatorChoice& choice = scenario.estimator;
  YamlNode root = scenario.resolved;
  SetYaml(root, "estimator.options", OnRobot(FindEstimator(choice.name), choice.options));
  return ReadScenario(root, scenario.name);
}

Scenario LoadScenario(const std::filesystem::path& path,
                      const std::vector<std::string>& overrides) {
  YamlNode root = LoadWithBases(path);
  const std::string name = path.stem().string();
  Scenario scenario = ReadScenario(root, name);
  if (overrides.empty()) return scenario;
  for (const std::string& assignment : overrides) SetYaml(root, assignment);
  return ReadScenario(root, name);
}

}  // namespace drydock
