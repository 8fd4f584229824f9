#include "sim/render/lens.h"

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

// An image whose value is the pinhole's own coordinate shows where each pixel looks.
TEST(Lens, EachPixelLooksAlongItsRay) {
  const Lens lens(Camera());
  const CameraModel model(Camera());
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

TEST(Lens, FoldedDistortionIsRefused) {
  CameraIntrinsics camera = Camera();
  camera.distortion = {-0.9, 0.0, 0.0, 0.0};
  EXPECT_THROW(Lens{camera}, InputError);
}

}  // namespace
}  // namespace drydock::sim
