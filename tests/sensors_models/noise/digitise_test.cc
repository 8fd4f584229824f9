#include "sensors_models/noise/digitise.h"

#include <gtest/gtest.h>

namespace drydock {
namespace {

TEST(Digitise, WithoutRangeAndResolutionNothingChanges) {
  for (const double value : {0.0, 1.0 / 3.0, -1e12, 1e-300}) {
    EXPECT_EQ(Digitise(value, 0.0, 0.0), value);
  }
}

TEST(Digitise, ClipsAtTheRange) {
  EXPECT_EQ(Digitise(4.99, 5.0, 0.0), 4.99);
  EXPECT_EQ(Digitise(5.01, 5.0, 0.0), 5.0);
  EXPECT_EQ(Digitise(-1e9, 5.0, 0.0), -5.0);
}

TEST(Digitise, RoundsToTheNearestStep) {
  EXPECT_EQ(Digitise(0.62, 0.0, 0.25), 0.5);
  EXPECT_EQ(Digitise(0.63, 0.0, 0.25), 0.75);
  EXPECT_EQ(Digitise(-0.63, 0.0, 0.25), -0.75);
  EXPECT_EQ(Digitise(0.125, 0.0, 0.25), 0.25);
  EXPECT_EQ(Digitise(-0.125, 0.0, 0.25), -0.25);
  EXPECT_EQ(Digitise(0.12, 0.0, 0.25), 0.0);
}

// 5 / 0.3 = 16.7 steps: the nearest to 5 would be the 17th, 5.1, which is out of range.
TEST(Digitise, RoundingStaysWithinTheRange) {
  EXPECT_DOUBLE_EQ(Digitise(5.0, 5.0, 0.3), 4.8);
  EXPECT_DOUBLE_EQ(Digitise(100.0, 5.0, 0.3), 4.8);
  EXPECT_DOUBLE_EQ(Digitise(-100.0, 5.0, 0.3), -4.8);
  EXPECT_DOUBLE_EQ(Digitise(4.7, 5.0, 0.3), 4.8);
}

// 0.3 / 0.1 is 2.999… in doubles.
TEST(Digitise, ARangeOfWholeStepsCanBeRead) { EXPECT_DOUBLE_EQ(Digitise(9.0, 0.3, 0.1), 0.3); }

}  // namespace
}  // namespace drydock
