#include "scenarios/runner/dive.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scoring/loops.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/resources.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

Scenario Bus(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all = {"sensors={stereo: {enabled: false}}"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return LoadScenario(DataDirectory() / "scenarios" / "bus.yaml", all);
}

void ExpectRefused(const std::vector<std::string>& overrides, const std::string& because) {
  const std::string error =
      InputErrorOf([&] { const Dive dive(Bus(overrides), sim::RendererBackend::kAuto); });
  EXPECT_THAT(error, ::testing::HasSubstr(because));
}

TEST(Dive, EveryShippedPathIsFree) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DataDirectory() / "scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    const Scenario scenario = LoadScenario(entry.path(), {"sensors={stereo: {enabled: false}}"});
    EXPECT_NO_THROW(Dive(scenario, sim::RendererBackend::kAuto)) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4);
}

std::size_t RevisitsOf(const std::string& name) {
  const Scenario scenario =
      LoadScenario(DataDirectory() / "scenarios" / name, {"sensors={stereo: {enabled: false}}"});
  const Dive dive(scenario, sim::RendererBackend::kAuto);
  return score::ScoreLoops(dive.Truth(), {}).revisits;
}

TEST(Dive, PlacesAreSeenAgainWhereTheyAreMeantToBe) {
  EXPECT_GT(RevisitsOf("bus_twice.yaml"), 200U);
  EXPECT_GE(RevisitsOf("bus_return.yaml"), 3U);
  EXPECT_EQ(RevisitsOf("columns.yaml"), 0U);
}

TEST(Dive, APathIntoTheBusIsRefused) {
  ExpectRefused({"motion.waypoints.3.position_m=[7, -2.5, 0]"}, "comes within");
}

TEST(Dive, UnknownSceneAndRigAreRefused) {
  ExpectRefused({"scene.name=submarine"}, "submarine");
  ExpectRefused({"rig=toaster"}, "toaster");
}

TEST(Dive, TruthCoversImuAndCameraInstants) {
  const Dive dive(Bus({"duration_s=2"}), sim::RendererBackend::kAuto);
  const Trajectory truth = dive.Truth();
  // 201 of the IMU and 31 of the camera; they share 0, 0.2, 0.4 … 2 s.
  EXPECT_EQ(truth.size(), 201U + 31U - 11U);
  EXPECT_LT(truth.front().T_WI.p().norm(), 1e-9) << "the world's origin is at the start";
}

TEST(Dive, TheSonarHitsNamedBodies) {
  Dive dive(Bus({"duration_s=10"}), sim::RendererBackend::kAuto);
  int hits = 0;
  while (const auto observation = dive.Next()) {
    if (const auto* truth = std::get_if<sim::SonarTruth>(&observation->truth);
        truth != nullptr && truth->range > 0) {
      EXPECT_FALSE(truth->body.empty());
      ++hits;
    }
  }
  EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace drydock
