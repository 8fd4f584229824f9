#include "scenarios/compare/finished.h"

#include <gtest/gtest.h>

#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"

namespace drydock::compare {
namespace {

TEST(FinishedCases, AreReadBackToTheLastBit) {
  const testing::TemporaryFolder folder;
  const FinishedCases cases(folder.path() / "finished");
  Finished kept;
  kept.scorecard.run.scenario = "bus";
  kept.scorecard.run.seed = 7;
  kept.scorecard.metrics.ate_rmse_m = 0.1 + 0.2;
  kept.estimator_s = 1.0 / 3.0;
  kept.stereo_frames = 15;
  kept.stages = {{"detection", 15, 0.25, 16.5, 20.0}};
  cases.Keep("abc", kept);
  const auto found = cases.Find("abc");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scorecard.run.scenario, "bus");
  EXPECT_EQ(found->scorecard.run.seed, 7U);
  EXPECT_EQ(found->scorecard.metrics.ate_rmse_m, 0.1 + 0.2);
  EXPECT_FALSE(found->scorecard.metrics.z_rmse_m);
  EXPECT_EQ(found->estimator_s, 1.0 / 3.0);
  EXPECT_EQ(found->stereo_frames, 15U);
  ASSERT_EQ(found->stages.size(), 1U);
  EXPECT_EQ(found->stages[0].name, "detection");
  EXPECT_EQ(found->stages[0].p99_ms, 20.0);
}

TEST(FinishedCases, WhatIsNotThereOrNotReadableIsNotFinished) {
  const testing::TemporaryFolder folder;
  const FinishedCases cases(folder.path());
  EXPECT_FALSE(cases.Find("abc"));
  WriteFileAtomically(folder.path() / "abc.json", "{\"scorecard\": 3}");
  EXPECT_FALSE(cases.Find("abc"));
  WriteFileAtomically(folder.path() / "abc.json", "not json");
  EXPECT_FALSE(cases.Find("abc"));
}

}  // namespace
}  // namespace drydock::compare
