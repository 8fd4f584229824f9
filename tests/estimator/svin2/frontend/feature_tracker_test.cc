#include "estimator/svin2/frontend/feature_tracker.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/estimator/svin2/frontend/tracked_wall.h"

namespace drydock::svin2 {
namespace {

using testing::Dive;
using testing::HalfRig;
using testing::PoseAt;
using testing::Shared;
using testing::Small;
using testing::TimeAt;
using testing::WallDive;

class AllWays : public ::testing::TestWithParam<Matching> {};

// After 5 frames a point has moved by some 25 px, and the errors have not added up.
TEST_P(AllWays, FollowsAMovingWallToATenthOfAPixel) {
  Dive dive(Small(GetParam()));
  const TrackedFrame first = dive.Swim(0);
  EXPECT_TRUE(first.is_keyframe);
  EXPECT_EQ(first.tracked, 0);
  EXPECT_EQ(first.empty_quadrants, 0);
  EXPECT_GE(first.points.size(), 60U);
  TrackedFrame frame;
  for (int k = 1; k <= 5; ++k) {
    frame = dive.Swim(k);
    EXPECT_LT(dive.RmsError(k, frame), 0.2);  // Of two coordinates.
    EXPECT_EQ(frame.t, TimeAt(k));
    EXPECT_TRUE(std::ranges::is_sorted(frame.points, {}, &TrackedPoint::id));
  }
  // Corners must be found afresh where descriptors do it all; patches lose those at the edge.
  EXPECT_GE(Shared(first, frame), GetParam() == Matching::kDescriptors ? 10U : 45U);
}

INSTANTIATE_TEST_SUITE_P(Matchings, AllWays,
                         ::testing::Values(Matching::kPatches, Matching::kDescriptors,
                                           Matching::kBoth));

TEST(FeatureTracker, StereoFindsNearlyAllOfAWall) {
  Dive dive(Small());
  const TrackedFrame frame = dive.Swim(0);
  std::size_t in_stereo = 0;
  for (const TrackedPoint& point : frame.points) in_stereo += point.right.has_value() ? 1 : 0;
  // Those at the left edge lie outside the right image.
  EXPECT_GE(in_stereo, frame.points.size() * 3 / 4);
  EXPECT_LT(dive.RmsError(0, frame), 0.2);
}

TEST(FeatureTracker, WorksWithoutPrediction) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0, false);
  for (int k = 1; k < 4; ++k) dive.Swim(k, false);
  const TrackedFrame last = dive.Swim(4, false);
  EXPECT_GE(Shared(first, last), first.points.size() * 3 / 5);
  EXPECT_LT(dive.RmsError(4, last), 0.2);
}

TEST(FeatureTracker, BlankImagesEndTracksButNothingElse) {
  Dive dive(Small());
  dive.Swim(0);
  StereoFrame blank;
  for (cv::Mat& image : blank.images) image = cv::Mat::zeros(300, 400, CV_8UC1);
  const TrackedFrame nothing = dive.See(1, blank);
  EXPECT_TRUE(nothing.points.empty());
  EXPECT_FALSE(nothing.is_keyframe);
  EXPECT_EQ(nothing.empty_quadrants, 4);
  const TrackedFrame afterwards = dive.Swim(2);
  EXPECT_TRUE(afterwards.is_keyframe);
  EXPECT_GE(afterwards.points.size(), 60U);
}

TEST(FeatureTracker, NeverUsesAnIdTwice) {
  Dive dive(Small(Matching::kPatches));  // With descriptors lost points get theirs back.
  const TrackedFrame first = dive.Swim(0);
  const WallDive other(2.5, 99);
  dive.See(1, other.See(PoseAt(1)));
  const TrackedFrame second = dive.Swim(2);
  EXPECT_TRUE(second.is_keyframe);
  EXPECT_EQ(first.points.front().id, 1U);
  EXPECT_EQ(Shared(first, second), 0U);
  EXPECT_GT(second.points.front().id, first.points.back().id);
}

TEST(FeatureTracker, WaitsWhereImagesCannotBeUsed) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  StereoFrame bad = dive.wall().See(PoseAt(1));
  bad.images[1] = cv::Mat::zeros(100, 100, CV_8UC1);
  EXPECT_TRUE(dive.See(1, bad).points.empty());
  bad.images[1] = cv::Mat::zeros(300, 400, CV_32FC1);
  EXPECT_TRUE(dive.See(1, bad).points.empty());
  EXPECT_TRUE(dive.See(1, StereoFrame{}).points.empty());
  EXPECT_GE(Shared(first, dive.Swim(1)), first.points.size() * 4 / 5);
}

// As after a camera's silence: the motion is that since the images that were used last.
TEST(FeatureTracker, KnowsAfterAWaitFromWhereItsTracksCome) {
  constexpr int kWait = 12;
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  for (int k = 1; k < kWait; ++k) dive.See(k, StereoFrame{});
  const TrackedFrame after = dive.Swim(kWait);
  EXPECT_GE(Shared(first, after), first.points.size() / 2);
  EXPECT_LT(dive.RmsError(kWait, after), 0.2);
}

TEST(FeatureTracker, IsDeterministic) {
  Dive one(Small()), two(Small());
  for (int k = 0; k < 4; ++k) {
    const TrackedFrame a = one.Swim(k), b = two.Swim(k);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(a.points[i].id, b.points[i].id);
      EXPECT_EQ(a.points[i].left, b.points[i].left);
      EXPECT_EQ(a.points[i].right, b.points[i].right);
      EXPECT_EQ(a.points[i].sigma_px, b.points[i].sigma_px);
    }
  }
}

// For one frame something swims before the cameras; then the wall is back where it was.
std::size_t ComeBack(Matching matching) {
  Dive dive(Small(matching));
  const TrackedFrame first = dive.Swim(0);
  const WallDive other(2.5, 99);
  dive.See(1, other.See(PoseAt(1)));
  for (int k = 2; k < 6; ++k) dive.See(k, other.See(PoseAt(k)));
  TrackedFrame back = dive.Swim(6);
  for (int k = 7; k < 10 && !back.is_keyframe; ++k) back = dive.Swim(k);
  return Shared(first, back);
}

TEST(FeatureTracker, DescriptorsRegainOldIds) {
  EXPECT_EQ(ComeBack(Matching::kPatches), 0U);
  EXPECT_GE(ComeBack(Matching::kBoth), 15U);
}

// The scene stands still but for one piece that is pasted elsewhere: RANSAC drops what is on it.
TEST(FeatureTracker, DropsWhatMovesOnItsOwn) {
  Dive dive(Small());
  const TrackedFrame first = dive.Swim(0);
  StereoFrame moved = dive.wall().See(PoseAt(0));
  const cv::Rect from(150, 100, 100, 80);
  const cv::Mat piece = moved.images[0](from).clone();
  piece.copyTo(moved.images[0](from + cv::Point(8, 8)));
  const auto lookup = [&](LandmarkId id) -> std::optional<Eigen::Vector3d> {
    for (const TrackedPoint& point : first.points) {
      if (point.id == id) return dive.wall().PointAt(PoseAt(0), 0, point.left);
    }
    return std::nullopt;
  };
  const TrackedFrame frame =
      dive.tracker().Track(TimeAt(1), moved, MotionPrediction{PoseAt(0), PoseAt(0)}, lookup);
  EXPECT_GE(frame.points.size(), 40U);
  for (const TrackedPoint& point : frame.points) {
    const auto p_W = lookup(point.id);
    if (!p_W.has_value()) continue;
    const Eigen::Vector2d error = dive.wall().PixelOf(PoseAt(0), 0, *p_W).value() - point.left;
    EXPECT_LT(error.norm(), 3.0);
  }
}

TEST(FeatureTracker, RefusesBadConfigurations) {
  FeatureTracker::Config none, unsure, negative;
  none.octaves = 0;
  unsure.sigma.coarse_px = 0.0;
  negative.unfollowed.enough_points = -1;
  for (const FeatureTracker::Config& config : {none, unsure, negative})
    EXPECT_THROW(FeatureTracker(config, HalfRig()), InputError);
}

}  // namespace
}  // namespace drydock::svin2
