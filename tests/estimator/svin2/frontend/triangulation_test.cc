#include "estimator/svin2/frontend/triangulation.h"

#include <Eigen/Cholesky>
#include <cmath>

#include <gtest/gtest.h>

#include "sensors_models/base/random_stream.h"

namespace drydock::svin2 {
namespace {

constexpr double kFocal = 500.0;

CameraModel Camera() {
  return CameraModel({.width = 800,
                      .height = 600,
                      .fx = kFocal,
                      .fy = kFocal,
                      .cx = 400.0,
                      .cy = 300.0,
                      .distortion = {-0.16, 0.1, 0.0, 0.0}});
}

// Cameras side by side along x, looking along z.
std::vector<View> Views(const CameraModel& camera, const Eigen::Vector3d& p_W,
                        const std::vector<double>& places) {
  std::vector<View> views;
  for (const double x : places) {
    const Pose T_WC(ExpSO3({0.02 * x, -0.05 * x, 0.1 * x}), {x, 0.0, 0.0});
    views.push_back({&camera, T_WC, camera.Project(T_WC.Inverse() * p_W).value(), 0.5});
  }
  return views;
}

TEST(Triangulate, FindsAPointFromTwoOrMoreViews) {
  const CameraModel camera = Camera();
  const Eigen::Vector3d p_W(0.4, -0.3, 3.0);
  for (const std::vector<double>& places :
       {std::vector<double>{0.0, 0.14}, std::vector<double>{0.0, 0.14, 0.5, 0.9}}) {
    const auto point = Triangulate(Views(camera, p_W, places));
    ASSERT_TRUE(point.IsGood());
    EXPECT_LT((point.p_W - p_W).norm(), 1e-7);
    EXPECT_LT(point.max_chi2, 1e-9);
  }
}

// On the axis, at depth z from a baseline b with sigma s of each pixel: the disparity d = f b / z
// has variance 2 s^2, so that depth has sigma z^2 / (f b) * sqrt(2) s; across the baseline, y is
// measured twice: z / f * s / sqrt(2).
TEST(Triangulate, SaysHowSureItIs) {
  const CameraModel camera = Camera();
  const double baseline = 0.14, depth = 4.0;
  std::vector<View> views;
  for (const double x : {-0.5 * baseline, 0.5 * baseline}) {
    const Pose T_WC(Eigen::Quaterniond::Identity(), {x, 0.0, 0.0});
    const Eigen::Vector3d p_C(-x, 0.0, depth);
    views.push_back({&camera, T_WC, camera.Project(p_C).value(), 0.5});
  }
  const auto point = Triangulate(views);
  ASSERT_TRUE(point.IsGood());
  const double sigma_z = depth * depth / (kFocal * baseline) * std::sqrt(2.0) * 0.5;
  EXPECT_NEAR(std::sqrt(point.covariance(2, 2)), sigma_z, 0.01 * sigma_z);
  const double sigma_y = depth / kFocal * 0.5 / std::sqrt(2.0);
  EXPECT_NEAR(std::sqrt(point.covariance(1, 1)), sigma_y, 0.01 * sigma_y);
  EXPECT_NEAR(point.parallax_rad, 2.0 * std::atan(0.5 * baseline / depth), 1e-9);
}

// The squared error, weighted by the covariance, is chi-square of 3: its mean over 1000 points is
// 3 with sigma sqrt(6 / 1000) = 0.08.
TEST(Triangulate, ItsCovarianceFitsItsErrors) {
  const CameraModel camera = Camera();
  RandomStream random(4, "test");
  double sum = 0.0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d p_W(random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 2.5);
    auto views = Views(camera, p_W, {0.0, 0.2, 0.5});
    for (View& view : views) {
      view.pixel += view.sigma_px * Eigen::Vector2d(random.Gaussian(), random.Gaussian());
    }
    const auto point = Triangulate(views, {.max_chi2 = 100.0});
    ASSERT_TRUE(point.IsGood());
    const Eigen::Vector3d error = point.p_W - p_W;
    sum += error.dot(point.covariance.ldlt().solve(error));
  }
  EXPECT_NEAR(sum / 1000.0, 3.0, 0.35);
}

TEST(Triangulate, RefusesWhatIsUncertainOrWrong) {
  const CameraModel camera = Camera();
  const Eigen::Vector3d near(0.1, 0.1, 2.0), far(0.0, 0.0, 40.0);
  using Status = TriangulationStatus;
  EXPECT_EQ(Triangulate(Views(camera, near, {0.0})).status, Status::kLowParallax);
  // 0.14 m at 40 m are 0.0035 rad.
  EXPECT_EQ(Triangulate(Views(camera, far, {0.0, 0.14})).status, Status::kLowParallax);
  EXPECT_EQ(Triangulate(Views(camera, near, {0.0, 0.14}), {.max_depth_m = 1.5}).status,
            Status::kOutOfRange);
  auto views = Views(camera, near, {0.0, 0.14});
  // Across the epipolar line by 4 px, that is 2 px (4 sigma, chi2 16) from either side.
  views[1].pixel.y() += 4.0;
  const auto wrong = Triangulate(views);
  EXPECT_EQ(wrong.status, Status::kHighChi2);
  EXPECT_NEAR(wrong.max_chi2, 16.0, 1.0);
  // Rays that meet behind the cameras.
  views = Views(camera, near, {0.0, 0.14});
  std::swap(views[0].pixel, views[1].pixel);
  EXPECT_EQ(Triangulate(views).status, Status::kOutOfRange);
  // Past the fold of a strong distortion: r (1 - 0.4 r^2) is never above 0.61, this is 0.78.
  const CameraModel folded({.width = 800,
                            .height = 600,
                            .fx = 500.0,
                            .fy = 500.0,
                            .cx = 400.0,
                            .cy = 300.0,
                            .distortion = {-0.4, 0.0, 0.0, 0.0}});
  views[0].camera = &folded;
  views[0].pixel = {790.0, 300.0};
  EXPECT_EQ(Triangulate(views).status, Status::kNoRay);
}

}  // namespace
}  // namespace drydock::svin2
