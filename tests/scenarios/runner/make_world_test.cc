#include "scenarios/runner/make_world.h"

#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes/creatures/creatures.h"
#include "sensors_models/base/resources.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

Scenario Bus(const std::vector<std::string>& overrides = {}) {
  return LoadScenario(DataDirectory() / "scenarios" / "bus.yaml", overrides);
}

TEST(MakeWorld, ScenariosAreStillUnlessTheySayOtherwise) {
  EXPECT_TRUE(Bus().moving.empty());
  EXPECT_TRUE(MakeWorld(Bus()).moving().bodies().empty());
}

TEST(MakeWorld, EveryCreatureThatCanBeAskedForIsThere) {
  std::string list;
  for (const std::string& kind : sim::FishKinds())
    list += fmt::format("{{what: fish, kind: {}, count: 2, centre_m: [1, 2, 3]}}, ", kind);
  const sim::World world =
      MakeWorld(Bus({"moving=[" + list + "{what: diver_arm}, {what: diver_arm, side: left}]"}));
  std::size_t parts = 0;
  for (const auto& [name, creature] : scenes::creatures::CreatureParts())
    parts += creature.size() * (name.starts_with("arm") ? 1 : 2);
  EXPECT_EQ(world.moving().bodies().size(), parts);
  EXPECT_EQ(world.moving_geoms().size(), parts);
  EXPECT_EQ(world.model().nmocap, static_cast<int>(parts));
}

TEST(MakeWorld, TheScenariosSeedMovesThem) {
  const auto first = [](const std::string& seed) {
    const sim::World world = MakeWorld(Bus({"moving=[{what: fish, centre_m: [1, 2, 3]}]", seed}));
    return world.moving().At(Time::FromSeconds(3.0), Pose()).at(0)->p();
  };
  EXPECT_EQ(first("seed=4"), first("seed=4"));
  EXPECT_NE(first("seed=4"), first("seed=5"));
}

TEST(MakeWorld, MistakesAreRefused) {
  const std::string error = testing::InputErrorOf(
      [] { Bus({"moving=[{what: fish, centre_m: [1, 2, 3], colour: red}]"}); });
  EXPECT_THAT(error, ::testing::HasSubstr("moving.0.colour"));
}

}  // namespace
}  // namespace drydock
