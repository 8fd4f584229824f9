#include "sensors_models/base/time.h"

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(Time, FifteenHertzStampsAreFlooredFromTheCount) {
  const Time start{0};
  EXPECT_EQ(SampleTime(start, 0, 15.0).ns, 0);
  EXPECT_EQ(SampleTime(start, 1, 15.0).ns, 66'666'666);
  EXPECT_EQ(SampleTime(start, 2, 15.0).ns, 133'333'333);
  EXPECT_EQ(SampleTime(start, 3, 15.0).ns, 200'000'000);
  EXPECT_EQ(SampleTime(start, 15, 15.0).ns, kNanosecondsPerSecond);
}

TEST(Time, NothingAccumulatesOverADay) {
  constexpr std::int64_t kDay = 86'400;
  EXPECT_EQ(SampleTime(Time{0}, kDay * 15, 15.0).ns, kDay * kNanosecondsPerSecond);
  EXPECT_EQ(SampleTime(Time{0}, kDay * 15 + 1, 15.0).ns, kDay * kNanosecondsPerSecond + 66'666'666);
}

TEST(Time, StartIsAddedToEveryStamp) {
  const Time start{1'600'000'000'000'000'007};
  EXPECT_EQ(SampleTime(start, 3, 100.0).ns, start.ns + 30'000'000);
}

TEST(Time, RatesBelowOneAndBetweenWholeNumbers) {
  EXPECT_EQ(SampleTime(Time{0}, 3, 0.5).ns, 6 * kNanosecondsPerSecond);
  EXPECT_EQ(SampleTime(Time{0}, 1, 2.5).ns, 400'000'000);
}

TEST(Time, SecondsAreRoundedToTheNearestNanosecond) {
  EXPECT_EQ(Time::FromSeconds(0.1).ns, 100'000'000);
  EXPECT_EQ(Time::FromSeconds(-1e-9).ns, -1);
  EXPECT_EQ(Duration::FromSeconds(1.4e-9).ns, 1);
  EXPECT_EQ(Duration::FromSeconds(1.6e-9).ns, 2);
}

TEST(Time, Arithmetic) {
  const Time t{5};
  const Duration d{3};
  EXPECT_EQ((t + d) - t, d);
  EXPECT_EQ((t - d).ns, 2);
  EXPECT_EQ((d - d).ns, 0);
  EXPECT_EQ((d + d).ns, 6);
  EXPECT_LT(t, t + d);
  EXPECT_EQ((Duration{1'500'000'000}).Seconds(), 1.5);
  EXPECT_EQ((Time{30 * kNanosecondsPerSecond}).Seconds(), 30.0);
  EXPECT_EQ((Time{100'000'000}).Seconds(), 0.1);
}

}  // namespace
}  // namespace drydock
