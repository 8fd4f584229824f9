#include "estimator/registry/registry.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

TEST(Registry, EveryEstimatorCanBeMade) {
  std::set<std::string_view> names;
  for (const EstimatorEntry& entry : Estimators()) {
    EXPECT_NE(entry.make(Rig{}, NoOptions()), nullptr) << entry.name;
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_TRUE(names.insert(entry.name).second) << "twice: " << entry.name;
  }
}

TEST(Registry, DeadReckoningTakesNoOptions) {
  const YamlNode options = ParseYaml("\nfrontend: {preprocess: false}\n", "dive.yaml");
  const std::string error =
      InputErrorOf([&] { FindEstimator("dead-reckoning").make(Rig{}, options); });
  EXPECT_EQ(error, "dive.yaml:2: unknown key 'frontend'; known here: none");
}

TEST(Registry, EveryEstimatorTakesItsOptionsOnARobot) {
  for (const EstimatorEntry& entry : Estimators())
    EXPECT_NE(entry.make(Rig{}, OnRobot(entry, NoOptions())), nullptr) << entry.name;
}

TEST(Registry, WhatIsSaidCountsOnARobotToo) {
  const EstimatorEntry& svin2 = FindEstimator("svin2-noloop");
  EXPECT_EQ(EmitYaml(OnRobot(svin2, ParseYaml("window: {iterations: 3}", "dive.yaml"))),
            "window:\n  solver_time_s: 0.03\n  iterations: 3\n");
  EXPECT_EQ(EmitYaml(OnRobot(svin2, ParseYaml("window: {solver_time_s: 0.1}", "dive.yaml"))),
            "window:\n  solver_time_s: 0.1\n");
}

TEST(Registry, UnknownNamesAreRefusedWithTheKnownOnes) {
  const std::string error = InputErrorOf([&] { FindEstimator("orb-slam"); });
  EXPECT_THAT(error, ::testing::HasSubstr("dead-reckoning"));
}

}  // namespace
}  // namespace drydock
