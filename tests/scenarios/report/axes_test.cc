#include "scenarios/report/axes.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drydock::report {
namespace {

using testing::ElementsAre;

TEST(Ticks, AreRoundAndWithinTheRange) {
  EXPECT_THAT(TickLabels(Ticks({-0.3, 10.2}, 5)), ElementsAre("0", "5", "10"));
  EXPECT_THAT(TickLabels(Ticks({0.0, 1.0}, 5)),
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(TickLabels(Ticks({-2.0, 2.0}, 4)), ElementsAre("-2", "-1", "0", "1", "2"));
  EXPECT_THAT(TickLabels(Ticks({1e-4, 3.1e-4}, 2)), ElementsAre("0.0001", "0.0002", "0.0003"));
}

TEST(Ticks, AreSomeButNeverMany) {
  for (double length = 1e-4; length < 1e6; length *= 1.37) {
    for (const double low : {0.0, -0.4 * length, 123.4}) {
      for (const int wanted : {2, 5, 12}) {
        const auto ticks = Ticks({low, low + length}, wanted);
        EXPECT_LE(ticks.size(), 2 * static_cast<std::size_t>(wanted) + 1) << low << " " << length;
        EXPECT_GE(ticks.size(), 2U) << low << " " << length;
      }
    }
  }
}

TEST(RangeOf, CoversTheValuesAndHasALength) {
  EXPECT_EQ(RangeOf({1.0, 5.0, -2.0}, 0.5).low, -2.0);
  EXPECT_EQ(RangeOf({1.0, 5.0, -2.0}, 0.5).high, 5.0);
  EXPECT_EQ(RangeOf({3.0}, 0.5).Length(), 0.5);
  EXPECT_EQ(RangeOf({3.0}, 0.5).Middle(), 3.0);
  EXPECT_EQ(RangeOf({}, 0.5).Length(), 0.5);
}

TEST(Axes, MapDataToTheFrame) {
  const Axes axes({100.0, 50.0, 200.0, 100.0}, {0.0, 10.0}, {-1.0, 1.0});
  EXPECT_EQ(axes.ToCanvas(0.0, -1.0), cv::Point2d(100.0, 150.0));
  EXPECT_EQ(axes.ToCanvas(10.0, 1.0), cv::Point2d(300.0, 50.0));
}

TEST(Axes, EqualScalesShowAllAndDistortNothing) {
  for (const Range y : {Range{0.0, 1.0}, Range{0.0, 100.0}}) {
    const Axes axes = Axes::WithEqualScales({0.0, 0.0, 300.0, 200.0}, {0.0, 10.0}, y);
    const auto origin = axes.ToCanvas(0.0, 0.0);
    const auto moved = axes.ToCanvas(1.0, 1.0);
    EXPECT_NEAR(moved.x - origin.x, origin.y - moved.y, 1e-9);
    EXPECT_LE(axes.x().low, 0.0);
    EXPECT_GE(axes.x().high, 10.0);
    EXPECT_LE(axes.y().low, y.low);
    EXPECT_GE(axes.y().high, y.high);
  }
}

}  // namespace
}  // namespace drydock::report
