#include "estimator/svin2/vocabulary/bag_of_words.h"

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

const BowVector kA = {{1, 0.5F}, {4, 0.25F}, {7, 0.25F}};
const BowVector kB = {{1, 0.125F}, {5, 0.5F}, {7, 0.375F}};

TEST(Score, IsOneOfEqualsAndZeroOfStrangers) {
  EXPECT_DOUBLE_EQ(Score(kA, kA), 1.0);
  EXPECT_DOUBLE_EQ(Score(kA, {{0, 0.5F}, {9, 0.5F}}), 0.0);
  EXPECT_DOUBLE_EQ(Score(kA, {}), 0.0);
  EXPECT_DOUBLE_EQ(Score({}, {}), 0.0);
}

// 1 - |a - b|_1 / 2 with |a - b|_1 = 0.375 + 0.25 + 0.5 + 0.125.
TEST(Score, IsThatOfTheL1Distance) {
  EXPECT_DOUBLE_EQ(Score(kA, kB), 1.0 - 0.5 * 1.25);
  EXPECT_DOUBLE_EQ(Score(kB, kA), Score(kA, kB));
}

}  // namespace
}  // namespace drydock::svin2
