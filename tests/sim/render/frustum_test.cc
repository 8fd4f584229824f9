#include "sim/render/frustum.h"

#include <Eigen/Geometry>
#include <numbers>

#include <gtest/gtest.h>

namespace drydock::sim {
namespace {

/// Edges at 45 degrees on all four sides; the camera looks along z.
const Pinhole kSquare{100, 100, 50.0, 49.5, 49.5};
const Frustum kFrustum(Pose(), kSquare, 0.1, 10.0);

BoxCorners Cube(const Eigen::Vector3d& centre, double half) {
  return CornersOfBox(centre, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(half));
}

TEST(Frustum, TellsHowFarABoxReaches) {
  const auto depth = kFrustum.FarthestDepth(Cube({0, 0, 5}, 0.5));
  ASSERT_TRUE(depth.has_value());
  EXPECT_NEAR(*depth, 5.5, 1e-12);
}

TEST(Frustum, SeesWhatCrossesItsFaces) {
  // At z = 5 the sides are at 5, at the box's far side z = 5.5 at 5.5: so far the cubes may reach.
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(kFrustum.FarthestDepth(Cube({sign * 5.99, 0, 5}, 0.5)));
    EXPECT_FALSE(kFrustum.FarthestDepth(Cube({sign * 6.01, 0, 5}, 0.5)));
    EXPECT_TRUE(kFrustum.FarthestDepth(Cube({0, sign * 5.99, 5}, 0.5)));
    EXPECT_FALSE(kFrustum.FarthestDepth(Cube({0, sign * 6.01, 5}, 0.5)));
  }
  EXPECT_TRUE(kFrustum.FarthestDepth(Cube({0, 0, 10.4}, 0.5)));
  EXPECT_FALSE(kFrustum.FarthestDepth(Cube({0, 0, 10.6}, 0.5)));
  EXPECT_TRUE(kFrustum.FarthestDepth(Cube({0, 0, -0.3}, 0.5)));
  EXPECT_FALSE(kFrustum.FarthestDepth(Cube({0, 0, -0.5}, 0.5)));
  // One that the camera is in.
  EXPECT_TRUE(kFrustum.FarthestDepth(Cube({0, 0, 0}, 20.0)));
}

TEST(Frustum, OffCentreImagesReachFurtherToOneSide) {
  // 100 columns right of the axis and none left of it, but for half a pixel each.
  const Frustum frustum(Pose(), {100, 100, 50.0, -0.5, 49.5}, 0.1, 10.0);
  EXPECT_TRUE(frustum.FarthestDepth(Cube({9.0, 0, 5}, 0.1)));
  EXPECT_FALSE(frustum.FarthestDepth(Cube({-0.2, 0, 5}, 0.1)));
}

TEST(Frustum, TurnedBoxesAreTighterThanTheirSpheres) {
  // A board of 4 m along x + z, 2 cm thick, beside the left face and parallel to it.
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.25 * std::numbers::pi, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto board = [&](double x) {
    return CornersOfBox({x, 0, 4.0}, R, Eigen::Vector3d(0.01, 0.5, 2.0));
  };
  EXPECT_FALSE(kFrustum.FarthestDepth(board(4.05)));
  EXPECT_TRUE(kFrustum.FarthestDepth(board(3.95)));
}

TEST(Frustum, FollowsTheCamera) {
  // From (1, 2, 3), looking along the world's x.
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Frustum frustum(Pose(Eigen::Quaterniond(R), {1, 2, 3}), kSquare, 0.1, 10.0);
  const auto depth = frustum.FarthestDepth(Cube({6, 2, 3}, 0.5));
  ASSERT_TRUE(depth.has_value());
  EXPECT_NEAR(*depth, 5.5, 1e-12);
  EXPECT_FALSE(frustum.FarthestDepth(Cube({-4, 2, 3}, 0.5)));
}

}  // namespace
}  // namespace drydock::sim
