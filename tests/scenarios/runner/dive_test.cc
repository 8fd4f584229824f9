#include "scenarios/runner/dive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/resources.h"

namespace drydock {
namespace {

Scenario Bus(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all = {"sensors={stereo: {enabled: false}}"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return LoadScenario(DataDirectory() / "scenarios" / "bus.yaml", all);
}

void ExpectRefused(const std::vector<std::string>& overrides, const std::string& because) {
  try {
    const Dive dive(Bus(overrides), sim::RendererBackend::kAuto);
    ADD_FAILURE() << "not refused: " << because;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(because));
  }
}

TEST(Dive, TheBusPathIsFree) { EXPECT_NO_THROW(Dive(Bus(), sim::RendererBackend::kAuto)); }

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
