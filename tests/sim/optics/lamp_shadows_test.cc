#include "sim/optics/lamp_shadows.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using testing::BoxElement;

const Pinhole kPinhole{401, 301, 300.0, 200.0, 150.0};
/// The camera looks along W's x axis, upright.
const Pose kT_WC(Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0, 0, 0});

/// A wall 4 m ahead with a post half-way before it, at the left of the axis.
class LampShadowsTest : public ::testing::Test {
 protected:
  /// Depth of what each pixel sees.
  cv::Mat Depth() const {
    cv::Mat depth(kPinhole.height, kPinhole.width, CV_32FC1);
    for (int v = 0; v < depth.rows; ++v) {
      for (int u = 0; u < depth.cols; ++u) {
        const Eigen::Vector3d ray((u - kPinhole.cx) / kPinhole.focal,
                                  (v - kPinhole.cy) / kPinhole.focal, 1.0);
        const auto hit = rays_.Cast(kT_WC.p(), kT_WC.q() * ray.normalized(), 50.0);
        depth.at<float>(v, u) = static_cast<float>(hit->range / ray.norm());
      }
    }
    return depth;
  }
  /// Share of the lamp along row 150.
  std::vector<float> Look(const ShiningDisc& disc) {
    LampShadows shadows(rays_, kPinhole, {disc});
    const cv::Mat depth = Depth();
    shadows.Look(depth, kT_WC);
    const float* row = shadows.Row(0, 150, depth.ptr<float>(150));
    return {row, row + kPinhole.width};
  }

  testing::TemporaryFolder folder_;
  World world_{
      testing::WriteScene(folder_.path(), BoxElement("wall", {4.05, 0, 0}, {0.05, 6, 6}) +
                                              BoxElement("post", {2, 0.3, 0}, {0.01, 0.1, 3}))};
  RayScene rays_{world_};
};

/// Share at the column that looks at y [m, in W] of the wall.
float OnWall(const std::vector<float>& row, double y) {
  return row[static_cast<std::size_t>(std::lround(200.0 - 300.0 * y / 4.0))];
}

// A lamp 0.4 m to the right of the camera (y = -0.4): the post from y = 0.2 to 0.4 at 2 m throws
// its shadow on the wall from y = 0.8 to 1.2, of which the post itself hides 0.4 to 0.8 from the
// camera.
TEST_F(LampShadowsTest, LieWhereGeometrySays) {
  const auto row = Look({{0.4, 0, 0}, {0, 0, 1}, 0.01});
  EXPECT_EQ(OnWall(row, 0.0), 1.F);
  EXPECT_EQ(OnWall(row, 0.3), 1.F);
  EXPECT_LT(OnWall(row, 0.9), 0.02F);
  EXPECT_LT(OnWall(row, 1.1), 0.02F);
  EXPECT_EQ(OnWall(row, 1.35), 1.F);
  // The post itself is lit up to its rims: it spans the columns from 140 to 170.
  for (int u = 143; u <= 167; ++u) EXPECT_GT(row[static_cast<std::size_t>(u)], 0.95F) << u;
}

TEST_F(LampShadowsTest, AreNotSeenFromTheLampItself) {
  for (const float share : Look({{0, 0, 0}, {0, 0, 1}, 0.0})) EXPECT_GT(share, 0.99F);
}

// The shadow's edge on the wall is as wide as the disc (as far behind the post as the disc is
// before it) or as the raster of 4 px makes it, 0.05 m a point there.
TEST_F(LampShadowsTest, LargeLampsThrowSoftShadows) {
  const auto width_of_edge = [&](double radius) {
    const auto row = Look({{0.4, 0, 0}, {0, 0, 1}, radius});
    int grey = 0;
    for (double y = 1.0; y < 1.9; y += 0.01) {
      const float share = OnWall(row, y);
      if (share > 0.1F && share < 0.9F) ++grey;
    }
    return 0.01 * grey;
  };
  EXPECT_LT(width_of_edge(0.01), 0.16);
  EXPECT_GT(width_of_edge(0.25), 0.2);
}

TEST_F(LampShadowsTest, EndlessWaterThrowsNone) {
  LampShadows shadows(rays_, kPinhole, {{{0.4, 0, 0}, {0, 0, 1}, 0.02}});
  const cv::Mat depth(kPinhole.height, kPinhole.width, CV_32FC1,
                      cv::Scalar(std::numeric_limits<float>::infinity()));
  shadows.Look(depth, kT_WC);
  const float* row = shadows.Row(0, 17, depth.ptr<float>(17));
  for (int u = 0; u < kPinhole.width; ++u) EXPECT_EQ(row[u], 1.F);
}

}  // namespace
}  // namespace drydock::sim
