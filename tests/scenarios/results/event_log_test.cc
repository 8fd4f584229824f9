#include "scenarios/results/event_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenarios/results/estimates.h"

namespace drydock {
namespace {

using testing::Estimate;

TEST(EventLog, NotesChangesWithTheTimeSinceTheStart) {
  const Time start = Time::FromSeconds(1'600'000'000.0);
  const auto at = [&](double seconds) { return start + Duration::FromSeconds(seconds); };
  EventLog log(start);
  log.Look(at(0.0), std::nullopt);
  log.Look(at(0.5), std::nullopt);
  log.Look(at(1.0), Estimate(TrackingStatus::kTracking, 0));
  log.Look(at(1.5), Estimate(TrackingStatus::kTracking, 0));
  log.Look(at(2.0), Estimate(TrackingStatus::kLost, 0));
  log.Look(at(2.25), Estimate(TrackingStatus::kTracking, 1));
  log.Look(at(3.0), Estimate(TrackingStatus::kDeadReckoning, 1));
  EXPECT_THAT(log.Take(),
              ::testing::ElementsAre("0.000 s: initialising, map 0", "1.000 s: tracking, map 0",
                                     "2.000 s: lost, map 0", "2.250 s: tracking, map 1",
                                     "3.000 s: dead reckoning, map 1"));
}

TEST(EventLog, PutsMessagesAmongTheChangesByTheirTimes) {
  EventLog log;
  log.Look(Time::FromSeconds(1.0), std::nullopt);
  log.Look(Time::FromSeconds(3.0), Estimate(TrackingStatus::kTracking, 0));
  log.Note({Time::FromSeconds(3.0), "initialised from gravity"});
  log.Note({Time::FromSeconds(2.0), "two stamps refused"});
  EXPECT_THAT(log.Take(), ::testing::ElementsAre(
                              "1.000 s: initialising, map 0", "2.000 s: two stamps refused",
                              "3.000 s: tracking, map 0", "3.000 s: initialised from gravity"));
}

}  // namespace
}  // namespace drydock
