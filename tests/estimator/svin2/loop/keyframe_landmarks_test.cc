#include "estimator/svin2/loop/keyframe_landmarks.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

TEST(KeyframeLandmarks, AreTheWindowsElseThoseOfStereo) {
  testing::SyntheticLoop loop = testing::MakeLoop();
  Keyframe keyframe = loop.then;
  for (KeyframePoint& point : keyframe.points) {
    point.p_I.reset();
    point.by_stereo = false;
  }
  keyframe.points[0].p_I = Eigen::Vector3d(7, 8, 9);
  keyframe.points[1].right.reset();
  TriangulateByStereo(loop.rig, keyframe);
  EXPECT_EQ(*keyframe.points[0].p_I, Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(keyframe.points[0].IsEstimated());
  EXPECT_FALSE(keyframe.points[1].p_I.has_value());
  for (std::size_t k = 2; k < keyframe.points.size(); ++k) {
    ASSERT_TRUE(keyframe.points[k].by_stereo);
    EXPECT_LT((*keyframe.points[k].p_I - loop.landmarks[k]).norm(), 1e-9);
  }
}

TEST(KeyframeLandmarks, AreSeenWhereTheImageIs) {
  const testing::SyntheticLoop loop = testing::MakeLoop();
  const auto pixel = PixelInLeft(loop.rig, loop.landmarks[0]);
  ASSERT_TRUE(pixel.has_value());
  EXPECT_LT((*pixel - loop.then.points[0].left).norm(), 1e-9);
  EXPECT_FALSE(PixelInLeft(loop.rig, {2, 3, 0}).has_value());
  EXPECT_FALSE(PixelInLeft(loop.rig, {-2, 0, 0}).has_value());
}

}  // namespace
}  // namespace drydock::svin2
