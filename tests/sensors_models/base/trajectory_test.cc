#include "sensors_models/base/trajectory.h"

#include <gtest/gtest.h>

namespace drydock {
namespace {

Trajectory ThreePoses() {
  return {{Time{0}, Pose(Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.0})},
          {Time{1000}, Pose(FromYawPitchRoll(1.0, 0.0, 0.0), {3.0, 4.0, 0.0})},
          {Time{3000}, Pose(FromYawPitchRoll(1.0, 0.0, 0.0), {3.0, 4.0, 2.0})}};
}

TEST(Trajectory, PathLengthIsThePolygons) {
  EXPECT_DOUBLE_EQ(PathLength(ThreePoses()), 7.0);
  EXPECT_EQ(PathLength({}), 0.0);
  EXPECT_EQ(PathLength({ThreePoses().front()}), 0.0);
}

TEST(Trajectory, InterpolatesBetweenNeighbours) {
  const auto pose = Interpolate(ThreePoses(), Time{250});
  ASSERT_TRUE(pose.has_value());
  EXPECT_NEAR((pose->p() - Eigen::Vector3d(0.75, 1.0, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(YawOf(pose->q()), 0.25, 1e-15);
}

TEST(Trajectory, GivesItsOwnPosesBackAndNothingOutside) {
  const Trajectory trajectory = ThreePoses();
  for (const StampedPose& pose : trajectory) {
    const auto found = Interpolate(trajectory, pose.t);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->p(), pose.T_WI.p());
  }
  EXPECT_FALSE(Interpolate(trajectory, Time{-1}).has_value());
  EXPECT_FALSE(Interpolate(trajectory, Time{3001}).has_value());
  EXPECT_FALSE(Interpolate({}, Time{0}).has_value());
}

}  // namespace
}  // namespace drydock
