#include "estimator/svin2/frontend/keyframe_rule.h"

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// `columns` x `rows` points 10 px apart, numbered along the columns; all of them in stereo.
std::vector<TrackedPoint> Grid(int columns, int rows) {
  std::vector<TrackedPoint> points;
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const Eigen::Vector2d pixel(10.0 * c, 10.0 * r);
      points.push_back({static_cast<LandmarkId>(100 * c + r + 1), pixel, pixel, 1.0});
    }
  }
  return points;
}

TrackedPoint LeftOnly(LandmarkId id, const Eigen::Vector2d& left) {
  return {id, left, std::nullopt, 1.0};
}

// After a keyframe of an 11 x 11 grid: a hull of 100 x 100 px^2.
KeyframeRule After(const KeyframeRule::Config& config) {
  KeyframeRule rule(config);
  EXPECT_TRUE(rule.Decide(Grid(11, 11)));  // The first frame always is one.
  rule.Keep(Grid(11, 11));
  EXPECT_FALSE(rule.Decide(Grid(11, 11)));
  return rule;
}

constexpr KeyframeRule::Config kByOverlap = {.min_tracked_share = 0.0, .min_gap = 1};

TEST(KeyframeRule, ComparesHulls) {
  EXPECT_FALSE(After(kByOverlap).Decide(Grid(8, 11)));  // 70 % of the area.
  EXPECT_TRUE(After(kByOverlap).Decide(Grid(7, 11)));   // 60 %.
}

TEST(KeyframeRule, TheBetterCameraDecides) {
  auto points = Grid(11, 11);
  for (TrackedPoint& point : points) {
    if (point.left.x() > 50.0) point.right.reset();  // Half of the right camera's hull is gone.
  }
  EXPECT_FALSE(After(kByOverlap).Decide(points));
}

TEST(KeyframeRule, ComparesNumbers) {
  // The hull is as it was, but of 121 points only 24 = 19.8 % are left; 25 are 20.7 %.
  auto points = Grid(11, 2);  // 22 points.
  points.push_back(LeftOnly(1011, {100.0, 100.0}));
  points.push_back(LeftOnly(11, {0.0, 100.0}));
  EXPECT_TRUE(After(kByOverlap).Decide(points));
  points.push_back(LeftOnly(511, {50.0, 100.0}));
  EXPECT_FALSE(After(kByOverlap).Decide(points));
}

TEST(KeyframeRule, PointsFoundSinceDoNotCount) {
  auto points = Grid(7, 11);
  points.push_back(LeftOnly(9999, {100.0, 100.0}));
  EXPECT_TRUE(After(kByOverlap).Decide(points));
}

TEST(KeyframeRule, ReplacesWhatIsLost) {
  constexpr KeyframeRule::Config kByNumber = {
      .max_overlap = 0.0, .max_match_ratio = 0.0, .min_tracked_share = 0.5, .min_gap = 1};
  EXPECT_FALSE(After(kByNumber).Decide(Grid(6, 11)));  // 66 of 121.
  EXPECT_TRUE(After(kByNumber).Decide(Grid(5, 11)));   // 55.
}

// What is gone at once was noise: it counts neither for the area nor for the number.
TEST(KeyframeRule, MeasuresFromTheFrameAfterTheKeyframe) {
  KeyframeRule rule({.min_gap = 1});
  rule.Keep(Grid(11, 11));
  EXPECT_FALSE(rule.Decide(Grid(5, 11)));
  EXPECT_FALSE(rule.Decide(Grid(4, 11)));  // 75 % of 40 x 100 px^2.
}

TEST(KeyframeRule, KeepsItsDistance) {
  KeyframeRule rule({.min_gap = 3, .max_gap = 5});
  rule.Keep(Grid(11, 11));
  EXPECT_FALSE(rule.Decide(Grid(11, 11)));
  EXPECT_FALSE(rule.Decide(Grid(1, 11)));
  EXPECT_TRUE(rule.Decide(Grid(1, 11)));
  rule.Keep(Grid(11, 11));
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(rule.Decide(Grid(11, 11)));
  EXPECT_TRUE(rule.Decide(Grid(11, 11)));
}

TEST(KeyframeRule, DarknessIsNoKeyframeButTheFirstLightIs) {
  KeyframeRule rule({.min_points = 10, .min_gap = 5});
  EXPECT_TRUE(rule.Decide({}));
  EXPECT_FALSE(rule.Keep({}));
  EXPECT_TRUE(rule.Decide({}));
  EXPECT_TRUE(rule.Keep(Grid(11, 11)));
  EXPECT_TRUE(rule.Decide({}));  // Whatever the gap.
  EXPECT_FALSE(rule.Decide(Grid(1, 9)));
  EXPECT_FALSE(rule.Keep(Grid(1, 9)));
  EXPECT_TRUE(rule.Keep(Grid(1, 10)));
}

TEST(KeyframeRule, RefusesBadConfigurations) {
  EXPECT_THROW(KeyframeRule({.max_overlap = 1.1}), InputError);
  EXPECT_THROW(KeyframeRule({.min_gap = 0}), InputError);
  EXPECT_THROW(KeyframeRule({.min_gap = 10, .max_gap = 5}), InputError);
}

}  // namespace
}  // namespace drydock::svin2
