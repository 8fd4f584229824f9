#include "scenarios/results/realtime_queue.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drydock {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Time At(double seconds) { return Time::FromSeconds(seconds); }

Measurement Frame(std::int64_t index, double t) { return {At(t), At(t), StereoFrame{index, {}}}; }

Measurement Imu(double t) { return {At(t), At(t), ImuSample{}}; }

/// The time of each measurement that still waits.
std::vector<double> Waiting(RealtimeQueue queue) {
  std::vector<double> times;
  while (const auto turn = queue.Next({std::numeric_limits<std::int64_t>::max()}))
    times.push_back(turn->measurement.t.Seconds());
  return times;
}

TEST(RealtimeQueue, AnIdleEstimatorBeginsAtTheArrival) {
  RealtimeQueue queue({});
  EXPECT_FALSE(queue.Next(At(1.0)));
  queue.Arrive({At(1.0), At(1.25), StereoFrame{}});
  EXPECT_FALSE(queue.Next(At(1.2)));
  const auto turn = queue.Next(At(2.0));
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->measurement.t, At(1.0));
  EXPECT_EQ(turn->begin, At(1.25));
  EXPECT_EQ(queue.report().longest_wait, Duration{});
}

TEST(RealtimeQueue, ABusyOneBeginsWhenItIsDone) {
  RealtimeQueue queue({});
  queue.Arrive(Imu(1.0));
  ASSERT_TRUE(queue.Next(At(1.0)));
  queue.Done(At(1.5));
  queue.Arrive(Imu(1.1));
  queue.Arrive(Imu(1.2));
  EXPECT_FALSE(queue.Next(At(1.4)));
  const auto turn = queue.Next(At(1.5));
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->measurement.t, At(1.1));
  EXPECT_EQ(turn->begin, At(1.5));
  EXPECT_EQ(queue.report().longest_wait, At(1.5) - At(1.1));
}

TEST(RealtimeQueue, TheNewestFramesStayAndEverythingElse) {
  for (const int length : {1, 2}) {
    RealtimeQueue queue({length});
    queue.Arrive(Imu(0.0));
    queue.Arrive(Frame(0, 0.1));
    queue.Arrive({At(0.2), At(0.2), DepthSample{}});
    queue.Arrive(Frame(1, 0.3));
    queue.Arrive({At(0.4), At(0.4), SonarPing{}});
    queue.Arrive(Frame(2, 0.5));
    queue.Arrive(Imu(0.6));
    EXPECT_EQ(queue.report().frames, 3);
    if (length == 1) {
      EXPECT_THAT(Waiting(queue), ElementsAre(0.0, 0.2, 0.4, 0.5, 0.6));
      EXPECT_THAT(queue.report().drops, ElementsAre(At(0.3), At(0.5)));
    } else {
      EXPECT_THAT(Waiting(queue), ElementsAre(0.0, 0.2, 0.3, 0.4, 0.5, 0.6));
      EXPECT_THAT(queue.report().drops, ElementsAre(At(0.5)));
    }
  }
}

TEST(RealtimeQueue, AFrameThatHadItsTurnWaitsNoLonger) {
  RealtimeQueue queue({});
  for (int k = 0; k < 5; ++k) {
    queue.Arrive(Frame(k, k));
    ASSERT_TRUE(queue.Next(At(k)));
    queue.Done(At(k));
  }
  EXPECT_THAT(queue.report().drops, IsEmpty());
}

TEST(DescribeDrops, SaysALineForThoseOfASecond) {
  EXPECT_THAT(DescribeDrops({}), IsEmpty());
  const auto events = DescribeDrops({9, {At(1.0), At(1.5), At(2.0), At(2.1), At(7.0)}, {}});
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].t, At(1.0));
  EXPECT_EQ(events[0].message, "3 stereo frames dropped within 1 s: the estimator was busy");
  EXPECT_EQ(events[1].t, At(2.1));
  EXPECT_EQ(events[2].t, At(7.0));
  EXPECT_EQ(events[2].message, "a stereo frame dropped: the estimator was busy");
}

}  // namespace
}  // namespace drydock
