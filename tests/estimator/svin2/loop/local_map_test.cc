#include "estimator/svin2/loop/local_map.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "estimator/svin2/loop/loop_checker.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

using testing::MakeLoop;
using testing::SyntheticLoop;

std::ptrdiff_t CountFrom(const Keyframe& map, LandmarkId k) {
  return std::ranges::count_if(map.points,
                               [k](const KeyframePoint& point) { return point.id % 5 == k; });
}

/// Keyframes along a short way past the landmarks of a loop, whose points have the ids 1 to 80: the
/// k-th keyframe sees those of id mod 5 = k that are in view.
class LocalMap : public ::testing::Test {
 protected:
  LocalMap() {
    Pose T_then_before;
    for (int k = 0; k < 5; ++k) {
      const Pose T_then_k(Eigen::Quaterniond::Identity(), {0.0, 0.05 * k, 0.0});
      Keyframe keyframe;
      keyframe.T_WI = loop_.then.T_WI * T_then_k;
      if (k > 0) keyframe.link = Link(T_then_before.Inverse() * T_then_k);
      T_then_before = T_then_k;
      for (KeyframePoint point : loop_.then.points)
        if (static_cast<int>(point.id % 5) == k && See(T_then_k, point))
          keyframe.points.push_back(point);
      keyframes_.push_back(std::move(keyframe));
    }
  }

  bool See(const Pose& T_then_k, KeyframePoint& point) const {
    const Eigen::Vector3d p_I = T_then_k.Inverse() * loop_.landmarks[point.id - 1];
    const auto left = testing::PixelOf(loop_.rig, 0, p_I);
    point.right = testing::PixelOf(loop_.rig, 1, p_I);
    if (!left || !point.right) return false;
    point.left = *left;
    point.p_I = p_I;
    return true;
  }

  static OdometryLink Link(const Pose& T_before_now) {
    return {T_before_now, 1e-6 * Eigen::Matrix<double, 6, 6>::Identity()};
  }

  Keyframe Around(std::size_t at, int reach) const {
    return LocalMapAround(loop_.rig, {.reach = reach}, keyframes_, at);
  }

  const SyntheticLoop loop_ = MakeLoop();
  std::vector<Keyframe> keyframes_;
};

TEST_F(LocalMap, HasTheKeyframesOwnPointsFirst) {
  const Keyframe map = Around(2, 1);
  ASSERT_GT(map.points.size(), keyframes_[2].points.size());
  for (std::size_t k = 0; k < keyframes_[2].points.size(); ++k) {
    EXPECT_EQ(map.points[k].id, keyframes_[2].points[k].id);
    EXPECT_EQ(map.points[k].left, keyframes_[2].points[k].left);
  }
}

TEST_F(LocalMap, SeesTheNeighboursLandmarksWhereTheyAre) {
  const Keyframe map = Around(2, 2);
  const Pose T_map_then(Eigen::Quaterniond::Identity(), {0.0, -0.1, 0.0});
  EXPECT_GE(map.points.size(), 75U) << "all but those beside the image";
  for (const KeyframePoint& point : map.points) {
    const Eigen::Vector3d p_I = T_map_then * loop_.landmarks[point.id - 1];
    EXPECT_LT((*point.p_I - p_I).norm(), 1e-8);
    EXPECT_LT((point.left - *testing::PixelOf(loop_.rig, 0, p_I)).norm(), 1e-6);
    EXPECT_LT((*point.right - *testing::PixelOf(loop_.rig, 1, p_I)).norm(), 1e-6);
  }
}

TEST_F(LocalMap, ReachesAsFarAsItIsTold) {
  EXPECT_EQ(Around(2, 0).points.size(), keyframes_[2].points.size());
  EXPECT_GT(CountFrom(Around(2, 1), 3), 0);
  EXPECT_EQ(CountFrom(Around(2, 1), 4), 0);
  EXPECT_GT(CountFrom(Around(0, 1), 1), 0) << "at the ends it reaches to one side";
  EXPECT_GT(CountFrom(Around(4, 1), 3), 0);
}

TEST_F(LocalMap, TakesEachLandmarkOnceAndFromTheNearest) {
  for (Keyframe& keyframe : keyframes_) keyframe.points = keyframes_[2].points;
  keyframes_[1].points[0].id = 7777;
  const Keyframe map = Around(2, 2);
  EXPECT_EQ(map.points.size(), keyframes_[2].points.size() + 1);
}

TEST_F(LocalMap, EndsWhereTheMapDoes) {
  keyframes_[3].link.reset();
  EXPECT_EQ(CountFrom(Around(2, 2), 3), 0);
  EXPECT_EQ(CountFrom(Around(2, 2), 4), 0);
  EXPECT_GT(CountFrom(Around(2, 2), 0), 0);
  EXPECT_EQ(CountFrom(Around(3, 2), 2), 0);
  EXPECT_GT(CountFrom(Around(3, 2), 4), 0);
}

// As after darkness: the keyframe that follows lies somewhere.
TEST_F(LocalMap, EndsWhereOdometryIsUnsure) {
  keyframes_[3].link->covariance.topLeftCorner<3, 3>() *= 1e4;
  EXPECT_EQ(CountFrom(Around(2, 2), 3), 0);
  keyframes_[3].link = Link(keyframes_[3].link->T_before_now);
  EXPECT_GT(CountFrom(Around(2, 2), 3), 0);
  keyframes_[3].link->covariance.bottomRightCorner<3, 3>() *= 1e4;
  EXPECT_EQ(CountFrom(Around(2, 2), 3), 0);
}

TEST_F(LocalMap, LeavesOutWhatHasNoDepth) {
  testing::CloseRightEye(keyframes_[1]);
  testing::CloseRightEye(keyframes_[3]);
  EXPECT_EQ(Around(2, 1).points.size(), keyframes_[2].points.size());
}

// Each keyframe alone has a fifth of the points.
TEST_F(LocalMap, IsRecognisedWhereOneKeyframeIsNot) {
  const LoopChecker checker({}, loop_.rig);
  const Pose T_now = Pose(Eigen::Quaterniond::Identity(), {0.0, -0.1, 0.0}) * loop_.T_then_now;
  const Keyframe& then = keyframes_[2];
  Keyframe now = loop_.now;
  std::erase_if(now.points, [](const KeyframePoint& point) { return point.id % 2 == 0; });
  EXPECT_FALSE(checker.Check(now, {}, then, {}, then, T_now).IsGood());
  const Relocalisation found = checker.Check(now, {}, then, {}, Around(2, 2), T_now);
  ASSERT_TRUE(found.IsGood()) << ToString(found.status);
  EXPECT_GE(found.inliers.size(), 30U);
  EXPECT_LT(testing::ErrorOf(found.T_then_now, T_now), 1e-6);
}

}  // namespace
}  // namespace drydock::svin2
