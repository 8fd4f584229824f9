#include "sim/render/lens.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

CameraIntrinsics Camera() {
  CameraIntrinsics camera;
  camera.width = 200;
  camera.height = 150;
  camera.fx = 144.0;
  camera.fy = 143.5;
  camera.cx = 97.0;
  camera.cy = 80.0;
  camera.distortion = {-0.16, 0.10, 0.001, -0.002};
  return camera;
}

/// Its corners look 54 degrees off the axis, where the pinhole is 1.5 to 2.9 times as fine.
CameraIntrinsics Fisheye() {
  CameraIntrinsics camera = Camera();
  camera.fx = 130.0;
  camera.fy = 129.5;
  camera.distortion = {-0.02, 0.01, -0.006, 0.001};
  camera.lens = LensModel::kEquidistant;
  return camera;
}

class EachLens : public ::testing::TestWithParam<CameraIntrinsics> {};

INSTANTIATE_TEST_SUITE_P(Lens, EachLens, ::testing::Values(Camera(), Fisheye()),
                         [](const auto& test) { return LensKey(test.param.lens); });

// An image whose value is the pinhole's own coordinate shows where each pixel looks.
TEST_P(EachLens, EachPixelLooksAlongItsRay) {
  const Lens lens(GetParam());
  const CameraModel model(GetParam());
  const Pinhole& source = lens.source();
  cv::Mat columns(source.height, source.width, CV_32FC1);
  for (int v = 0; v < source.height; ++v) {
    for (int u = 0; u < source.width; ++u) columns.at<float>(v, u) = static_cast<float>(u);
  }
  cv::Mat seen;
  lens.ApplySmooth(columns, seen);
  ASSERT_EQ(seen.size(), cv::Size(200, 150));
  for (int v = 0; v < 150; ++v) {
    for (int u = 0; u < 200; ++u) {
      const double expected = (*model.Unproject({u, v})).x() * source.focal + source.cx;
      ASSERT_NEAR(seen.at<float>(v, u), expected, 1e-3) << u << ", " << v;
    }
  }
}

// The nearest pixel is within half a pixel of where the camera's pixel looks.
TEST_P(EachLens, DepthIsThatOfTheNearestPixel) {
  const Lens lens(GetParam());
  const CameraModel model(GetParam());
  const Pinhole& source = lens.source();
  cv::Mat rows(source.height, source.width, CV_32FC1);
  for (int v = 0; v < source.height; ++v) rows.row(v).setTo(v);
  cv::Mat seen;
  lens.ApplyNearest(rows, seen);
  for (int v = 0; v < 150; ++v) {
    for (int u = 0; u < 200; ++u) {
      const double expected = (*model.Unproject({u, v})).y() * source.focal + source.cy;
      ASSERT_NEAR(seen.at<float>(v, u), expected, 0.5 + 1e-4) << u << ", " << v;
    }
  }
}

// Columns of the pinhole, black and white by turns, are grey where a pixel has two or more of them.
// In the middle, where it has one, some of them must be seen.
TEST(Lens, FineTexturesDoNotAlias) {
  const Lens lens(Fisheye());
  const CameraModel model(Fisheye());
  const Pinhole& source = lens.source();
  cv::Mat stripes(source.height, source.width, CV_32FC1);
  for (int u = 0; u < source.width; ++u) stripes.col(u).setTo(u % 2);
  cv::Mat seen;
  lens.ApplySmooth(stripes, seen);
  double border = 0.0, middle = 0.0;
  for (int v = 70; v < 90; ++v) {
    for (const int u : {2, 3, 4, 5, 196, 197})
      border = std::max(border, std::abs(seen.at<float>(v, u) - 0.5));
    for (int u = 90; u < 110; ++u) middle = std::max(middle, std::abs(seen.at<float>(v, u) - 0.5));
  }
  EXPECT_LT(border, 0.25);
  EXPECT_GT(middle, 0.4);
}

TEST(Lens, ViewsTooWideToDrawAreRefused) {
  CameraIntrinsics camera = Fisheye();
  camera.fx = camera.fy = 60.0;  // 119 degrees in a corner.
  EXPECT_THROW(Lens{camera}, InputError);
  camera.fx = camera.fy = 88.0;  // 84 degrees in a corner: more than four times as wide.
  EXPECT_THROW(Lens{camera}, InputError);
}

TEST(Lens, FoldedDistortionIsRefused) {
  CameraIntrinsics camera = Camera();
  camera.distortion = {-0.9, 0.0, 0.0, 0.0};
  EXPECT_THROW(Lens{camera}, InputError);
}

}  // namespace
}  // namespace drydock::sim
