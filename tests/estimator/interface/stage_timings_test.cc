#include "estimator/interface/stage_timings.h"

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(StageClock, SumsUpEachStageInTheOrderInWhichTheyFirstRan) {
  StageClock clock;
  // 1 to 200 ms, largest first: 100 of the 200 are at most 100 ms, 198 of them at most 198 ms.
  for (int ms = 200; ms >= 1; --ms) clock.Add("optimisation", 1e-3 * ms);
  clock.Add("detection", 0.25);
  const EstimatorTimings timings = clock.Summary();
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].name, "optimisation");
  EXPECT_EQ(timings[0].count, 200U);
  EXPECT_NEAR(timings[0].total_s, 20.1, 1e-12);  // 200 * 201 / 2 ms.
  EXPECT_NEAR(timings[0].median_ms, 100.0, 1e-9);
  EXPECT_NEAR(timings[0].p99_ms, 198.0, 1e-9);
  EXPECT_EQ(timings[1].name, "detection");
  EXPECT_EQ(timings[1].count, 1U);
  EXPECT_EQ(timings[1].median_ms, 250.0);
  EXPECT_EQ(timings[1].p99_ms, 250.0);
}

TEST(StageClock, ALapIsOneFrame) {
  StageClock clock;
  { const StageClock::Lap lap(clock, "detection"); }
  ASSERT_EQ(clock.Summary().size(), 1U);
  EXPECT_EQ(clock.Summary()[0].count, 1U);
  EXPECT_GE(clock.Summary()[0].total_s, 0.0);
}

TEST(StageClock, NothingRanNothingToSay) { EXPECT_TRUE(StageClock().Summary().empty()); }

}  // namespace
}  // namespace drydock
