#include "estimator/svin2/loop/keyframe_landmarks.h"

#include <gtest/gtest.h>

#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

TEST(KeyframeLandmarks, AreTheWindowsElseThoseOfStereo) {
  testing::SyntheticLoop loop = testing::MakeLoop();
  loop.then.points[0].p_I = Eigen::Vector3d(7, 8, 9);
  loop.then.points[1].right.reset();
  const auto landmarks = LandmarksOf(loop.rig, loop.then);
  ASSERT_EQ(landmarks.size(), loop.landmarks.size());
  EXPECT_EQ(landmarks[0], Eigen::Vector3d(7, 8, 9));
  EXPECT_FALSE(landmarks[1].has_value());
  for (std::size_t k = 2; k < landmarks.size(); ++k)
    EXPECT_LT((*landmarks[k] - loop.landmarks[k]).norm(), 1e-9);
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
