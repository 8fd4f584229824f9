#include "scenarios/results/start_watch.h"

#include <gtest/gtest.h>

#include "tests/scenarios/results/estimates.h"

namespace drydock {
namespace {

using testing::Estimate;

TEST(StartWatch, CountsStartsThatAreGivenUpSoon) {
  StartWatch starts;
  const auto look = [&](double t, TrackingStatus status, int map_id) {
    starts.Look(Time::FromSeconds(t), Estimate(status, map_id));
  };
  starts.Look(Time{}, std::nullopt);
  EXPECT_FALSE(starts.FalseStarts());
  look(1.0, TrackingStatus::kTracking, 0);
  EXPECT_EQ(starts.FalseStarts(), 0);
  look(3.0, TrackingStatus::kInitialising, 0);  // After 2 s: false.
  EXPECT_EQ(starts.FalseStarts(), 1);
  look(4.0, TrackingStatus::kTracking, 0);
  look(4.5, TrackingStatus::kLost, 0);
  look(9.0, TrackingStatus::kTracking, 1);  // Another map after 5 s: false.
  EXPECT_EQ(starts.FalseStarts(), 2);
  look(14.1, TrackingStatus::kTracking, 2);  // After 5.1 s: lost, but the start was none too soon.
  EXPECT_EQ(starts.FalseStarts(), 2);
}

}  // namespace
}  // namespace drydock
