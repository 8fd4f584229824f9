#include "sim/world/moving_things_config.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/input_error.h"

namespace drydock::sim {
namespace {

using ::testing::HasSubstr;
using testing::InputErrorOf;

MovingThingConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "dive.yaml"),
                  [](YamlReader& yaml) { return ReadMovingThing(yaml); });
}

TEST(MovingThingConfig, AShoalIsRead) {
  const MovingThingConfig thing = Read(
      "{what: fish, kind: perch, count: 7, centre_m: [1, -2, 3], radius_m: 2.5, "
      "speed_m_s: 0.6, size_m: 0.2, from_s: 4, to_s: 9.5}");
  const auto& shoal = std::get<ShoalConfig>(thing.what);
  EXPECT_EQ(shoal.kind, "perch");
  EXPECT_EQ(shoal.count, 7);
  EXPECT_EQ(shoal.centre_m, Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(shoal.radius_m, 2.5);
  EXPECT_EQ(shoal.speed_m_s, 0.6);
  EXPECT_EQ(shoal.size_m, 0.2);
  EXPECT_EQ(thing.from_s, 4.0);
  EXPECT_EQ(thing.to_s, 9.5);
}

TEST(MovingThingConfig, WhatIsLeftOutHasItsDefault) {
  const MovingThingConfig fish = Read("{what: fish, centre_m: [0, 0, 0]}");
  EXPECT_EQ(std::get<ShoalConfig>(fish.what).count, 1);
  EXPECT_EQ(std::get<ShoalConfig>(fish.what).kind, "bream");
  EXPECT_EQ(fish.from_s, 0.0);
  EXPECT_TRUE(std::isinf(fish.to_s));
  const MovingThingConfig arm = Read("{what: diver_arm}");
  EXPECT_FALSE(std::get<DiverArmConfig>(arm.what).left);
  EXPECT_TRUE(std::get<DiverArmConfig>(Read("{what: diver_arm, side: left}").what).left);
}

TEST(MovingThingConfig, MistakesAreNamed) {
  const auto expect = [](const std::string& text, const std::string& key,
                         const std::string& because) {
    const std::string error = InputErrorOf([&] { Read(text); });
    EXPECT_THAT(error, HasSubstr("dive.yaml:1")) << text;
    EXPECT_THAT(error, HasSubstr(key)) << text;
    EXPECT_THAT(error, HasSubstr(because)) << text;
  };
  expect("{count: 3}", "what", "fish or diver_arm");
  expect("{what: shark}", "what", "diver_arm");
  expect("{what: fish}", "centre_m", "");
  expect("{what: fish, centre_m: [0, 0, 0], kind: shark}", "kind", "perch");
  expect("{what: fish, centre_m: [0, 0, 0], count: 0}", "count", "100");
  expect("{what: fish, centre_m: [0, 0, 0], count: 101}", "count", "101");
  expect("{what: fish, centre_m: [0, 0, 0], speed_m_s: -1}", "speed_m_s", "-1");
  expect("{what: fish, centre_m: [0, 0, 0], size_m: 0.3, radius_m: 0.59}", "radius_m",
         "twice size_m");
  expect("{what: fish, centre_m: [0, 0, 0], from_s: 3, to_s: 3}", "to_s", "later than from_s");
  expect("{what: fish, centre_m: [0, 0, 0], side: left}", "side", "");
  expect("{what: diver_arm, side: middle}", "side", "left");
  expect("{what: diver_arm, count: 2}", "count", "");
}

}  // namespace
}  // namespace drydock::sim
