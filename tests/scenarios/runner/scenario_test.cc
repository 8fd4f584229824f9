#include "scenarios/runner/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/resources.h"
#include "tests/support/input_error.h"
#include "tests/support/temporary_folder.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

constexpr const char* kSmall = R"(summary: A short test
scene: {name: bus}
rig: svin2_v3
motion:
  waypoints:
    - {position_m: [0, 0, 0]}
    - {position_m: [1, 0, 0]}
)";

class ScenarioTest : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    WriteFileAtomically(folder_.path() / name, text);
    return folder_.path() / name;
  }

  testing::TemporaryFolder folder_;
};

TEST_F(ScenarioTest, EveryShippedScenarioLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DataDirectory() / "scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(LoadScenario(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 1);
}

TEST_F(ScenarioTest, DefaultsAreFilledIn) {
  const Scenario scenario = LoadScenario(Write("small.yaml", kSmall));
  EXPECT_EQ(scenario.name, "small");
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.estimator.name, "svin2");
  EXPECT_EQ(scenario.estimator.rig, "svin2_v3");
  EXPECT_FALSE(scenario.duration_s);
}

TEST_F(ScenarioTest, InheritsFromItsBase) {
  Write("small.yaml", kSmall);
  const Scenario scenario = LoadScenario(
      Write("murky.yaml", "base: small.yaml\nsummary: Murky\nwater: {visibility_m: 3}\nseed: 5\n"));
  EXPECT_EQ(scenario.summary, "Murky");
  EXPECT_EQ(scenario.water.visibility_m, 3.0);
  EXPECT_EQ(scenario.seed, 5U);
  EXPECT_EQ(scenario.motion.waypoints.size(), 2U);
  EXPECT_EQ(scenario.resolved.Find("base"), nullptr);
}

TEST_F(ScenarioTest, BasesMustEnd) {
  Write("a.yaml", "base: b.yaml\n");
  EXPECT_THROW(LoadScenario(Write("b.yaml", "base: a.yaml\n")), InputError);
}

TEST_F(ScenarioTest, SetOverridesKeys) {
  const auto path = Write("small.yaml", kSmall);
  const Scenario scenario =
      LoadScenario(path, {"seed=9", "motion.waypoints.1.position_m=[2, 0, 0]", "duration_s=3.5"});
  EXPECT_EQ(scenario.seed, 9U);
  EXPECT_EQ(scenario.motion.waypoints[1].position.x(), 2.0);
  EXPECT_EQ(*scenario.duration_s, 3.5);
}

TEST_F(ScenarioTest, EstimatorOptionsAreKeptForTheEstimator) {
  const std::string options = "estimator: {options: {}}\n";
  const Scenario scenario = LoadScenario(Write("small.yaml", kSmall + options));
  EXPECT_EQ(scenario.estimator.options.kind, YamlNode::Kind::kMap);
  EXPECT_NE(EmitYaml(scenario.resolved).find("options: {}"), std::string::npos)
      << "the manifest and the configuration's hash hold them";
  EXPECT_NE(MakeEstimator(scenario.estimator), nullptr);
}

TEST_F(ScenarioTest, BrokenOnesAreNamed) {
  struct Case {
    std::string text;
    std::string override_;
    std::string expected;
  };
  const std::string small = kSmall;
  const std::vector<Case> cases = {
      {"", "", "x.yaml"},
      {"[1, 2]\n", "", "mapping"},
      {small + "sed: 1\n", "", "x.yaml:8: unknown key 'sed'"},
      {small + "seed: 1\nseed: 2\n", "", "x.yaml:9: the key 'seed' stands twice"},
      {small + "seed: -1\n", "", "x.yaml:8: seed is -1"},
      {small + "seed: 1.5\n", "", "x.yaml:8: seed is 1.5"},
      {small + "seed: \"1\"\n", "", "x.yaml:8: seed is \"1\""},
      {small + "duration_s: .nan\n", "", "x.yaml:8: duration_s is .nan"},
      {small + "duration_s: .inf\n", "", "x.yaml:8: duration_s"},
      {small + "water: {visibility_m: -3}\n", "", "x.yaml:8: water.visibility_m is -3"},
      {small + "water: {jerlov_type: IX}\n", "", "one of IB, II, III"},
      {small + "water: 12\n", "", "x.yaml:8: water is 12, must be a mapping"},
      {small + "estimator: {name: magic}\n", "", "dead-reckoning"},
      {small + "criteria: [{metric: ate, max: 1}]\n", "", "x.yaml:8"},
      {small + "criteria: [{metric: ate_rmse_m}]\n", "", "x.yaml:8"},
      {small, "seed", "--set seed"},
      {small, "seed=abc", "--set seed=abc"},
      {small, "motion.waypoints.7.position_m=[0, 0, 0]", "leads nowhere"},
      {small, "colour=red", "colour"},
      {"base: missing.yaml\n", "", "missing.yaml"},
      {"summary: [a\n", "", "x.yaml:2"},
  };
  for (const Case& broken : cases) {
    const auto path = Write("x.yaml", broken.text);
    const std::vector<std::string> overrides =
        broken.override_.empty() ? std::vector<std::string>{} : std::vector{broken.override_};
    EXPECT_THAT(InputErrorOf([&] { LoadScenario(path, overrides); }),
                ::testing::HasSubstr(broken.expected))
        << broken.text << broken.override_;
  }
}

}  // namespace
}  // namespace drydock
