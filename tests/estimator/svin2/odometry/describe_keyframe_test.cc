#include "estimator/svin2/odometry/describe_keyframe.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/synthetic_motion.h"
#include "tests/estimator/svin2/synthetic_tracks.h"

namespace drydock::svin2 {
namespace {

class DescribeKeyframeTest : public ::testing::Test {
 protected:
  DescribeKeyframeTest()
      : tracks_(200, 0.0),
        window_({}, StereoGeometry(testing::SyntheticStereo())),
        state_(testing::MotionAt(Time{})),
        seen_(tracks_.See(Time{}, state_.T_WI)) {
    for (std::size_t k = 0; k < seen_.points.size(); ++k)
      if (k % 4 != 0) seen_.points[k].descriptor = Descriptor{k};
    window_.Start(state_, {}, seen_);
    window_.Optimise();
  }

  std::vector<LandmarkId> Estimated(std::size_t count) const {
    std::vector<LandmarkId> ids;
    for (const TrackedPoint& point : seen_.points)
      if (point.descriptor && window_.LandmarkPosition(point.id) && ids.size() < count)
        ids.push_back(point.id);
    return ids;
  }

  testing::SyntheticTracks tracks_;
  SlidingWindow window_;
  NavState state_;
  TrackedFrame seen_;
};

TEST_F(DescribeKeyframeTest, HasWhatIsDescribed) {
  const Keyframe keyframe = DescribeKeyframe(window_, seen_, {});
  EXPECT_EQ(keyframe.t, seen_.t);
  EXPECT_LT((keyframe.T_WI.p() - state_.T_WI.p()).norm(), 1e-9);
  EXPECT_FALSE(keyframe.link);
  EXPECT_TRUE(keyframe.covariance);
  ASSERT_EQ(keyframe.points.size(), seen_.points.size() - (seen_.points.size() + 3) / 4);
  int landmarks = 0;
  for (const KeyframePoint& point : keyframe.points) {
    const auto p_W = window_.LandmarkPosition(point.id);
    ASSERT_EQ(point.p_I.has_value(), p_W.has_value());
    if (!p_W) continue;
    EXPECT_LT((state_.T_WI * *point.p_I - *p_W).norm(), 1e-9);
    ++landmarks;
  }
  EXPECT_GT(landmarks, 50);
}

// They have no landmark in the window, but stereo tells their place.
TEST_F(DescribeKeyframeTest, HasWhatNobodyFollowsBehindTheRest) {
  const std::size_t before = DescribeKeyframe(window_, seen_, {}).points.size();
  TrackedPoint coarse = seen_.points.front();
  coarse.id = LandmarkId{1} << 63U;
  coarse.sigma_px = 2.0;
  coarse.descriptor = Descriptor{7};
  seen_.unfollowed = {coarse};
  const Keyframe keyframe = DescribeKeyframe(window_, seen_, {});
  ASSERT_EQ(keyframe.points.size(), before + 1);
  const KeyframePoint& last = keyframe.points.back();
  EXPECT_EQ(last.id, coarse.id);
  EXPECT_EQ(last.right, coarse.right);
  EXPECT_EQ(last.descriptor, *coarse.descriptor);
  EXPECT_EQ(last.sigma_px, 2.0);
  EXPECT_FALSE(last.p_I.has_value());
}

TEST_F(DescribeKeyframeTest, HasTheLinkOfTheWindowAndLandmarksAsTheyAreSeenFromThere) {
  const Time t{200'000'000};
  const auto samples = testing::MotionSamples(Time{}, t, Duration{1'000'000});
  TrackedFrame later = tracks_.See(t, testing::MotionAt(t).T_WI);
  for (TrackedPoint& point : later.points) point.descriptor = Descriptor{point.id};
  TrackedPoint unknown = later.points.back();
  unknown.id = 1000;
  window_.AddFrame(later, *ImuPreintegration::Over(samples, Time{}, t, {}, ImuNoiseModel{}));
  window_.Optimise();
  later.points.push_back(unknown);
  const Keyframe keyframe = DescribeKeyframe(window_, later, {});
  ASSERT_TRUE(keyframe.link);
  EXPECT_EQ(keyframe.link->T_before_now.p(), window_.LinkToKeyframe()->T_before_now.p());
  EXPECT_EQ(keyframe.link->covariance, window_.LinkToKeyframe()->covariance);
  const Pose T_IW = testing::MotionAt(t).T_WI.Inverse();
  int landmarks = 0;
  for (const KeyframePoint& point : keyframe.points) {
    EXPECT_EQ(point.descriptor[0], point.id == 1000 ? later.points.end()[-2].id : point.id);
    if (!point.p_I) continue;
    EXPECT_LT((*point.p_I - T_IW * tracks_.landmarks()[point.id - 1]).norm(), 1e-3) << point.id;
    ++landmarks;
  }
  EXPECT_GT(landmarks, 50);
  EXPECT_FALSE(keyframe.points.back().p_I) << "the window does not know it";
}

TEST_F(DescribeKeyframeTest, HasPingsOfWhichItSeesTheWholePatch) {
  SonarRangeObservation observation;
  observation.range = 2.5;
  const std::vector<LandmarkId> whole = Estimated(5);
  std::vector<LandmarkId> not_described = whole;
  not_described.push_back(seen_.points[0].id);
  const Keyframe keyframe =
      DescribeKeyframe(window_, seen_, {{observation, whole}, {observation, not_described}});
  ASSERT_EQ(keyframe.pings.size(), 1U);
  EXPECT_EQ(keyframe.pings[0].observation.range, 2.5);
  ASSERT_EQ(keyframe.pings[0].points.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_EQ(keyframe.points[keyframe.pings[0].points[k]].id, whole[k]);
}

}  // namespace
}  // namespace drydock::svin2
