#include "sensors_models/models/camera_model.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "sensors_models/base/random_stream.h"
#include "tests/support/numeric.h"

namespace drydock {
namespace {

CameraIntrinsics Camera(const std::array<double, 4>& distortion,
                        LensModel lens = LensModel::kRadtan) {
  CameraIntrinsics camera;
  camera.width = 800;
  camera.height = 600;
  camera.fx = 575.3;
  camera.fy = 574.6;
  camera.cx = 399.4;
  camera.cy = 288.3;
  camera.distortion = distortion;
  camera.lens = lens;
  return camera;
}

const std::array<double, 4> kSome = {-0.16, 0.102, 0.0013, -0.0021};
const std::array<double, 4> kFisheye = {-0.013, 0.021, -0.012, 0.0024};

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  RandomStream random(1, "camera");
  for (const auto& distortion : {kSome, std::array<double, 4>{}}) {
    const CameraIntrinsics camera = Camera(distortion);
    const CameraModel model(camera);
    const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 500; ++i) {
      const double z = random.Uniform(0.3, 20.0);
      const double x = random.Uniform(-0.7, 0.7) * z;
      const double y = random.Uniform(-0.5, 0.5) * z;
      points.emplace_back(x, y, z);
    }
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), K,
                      cv::Vec4d(distortion[0], distortion[1], distortion[2], distortion[3]),
                      pixels);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto pixel = model.Project({points[i].x, points[i].y, points[i].z});
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x(), pixels[i].x, 1e-9);
      EXPECT_NEAR(pixel->y(), pixels[i].y, 1e-9);
    }
  }
}

// Also far off the axis: z is down to a seventh of x.
TEST(CameraModel, ProjectsAsOpenCvsFisheyeDoes) {
  RandomStream random(3, "camera");
  for (const auto& distortion : {kFisheye, std::array<double, 4>{}}) {
    const CameraIntrinsics camera = Camera(distortion, LensModel::kEquidistant);
    const CameraModel model(camera);
    const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    std::vector<cv::Point3d> points = {{0, 0, 2}, {1e-7, 0, 1}, {0, -1e-13, 1}};
    for (int i = 0; i < 500; ++i) {
      const double z = random.Uniform(0.3, 20.0);
      points.emplace_back(random.Uniform(-7.0, 7.0) * z, random.Uniform(-5.0, 5.0) * z, z);
    }
    std::vector<cv::Point2d> pixels;
    cv::fisheye::projectPoints(
        points, pixels, cv::Vec3d(), cv::Vec3d(), K,
        cv::Vec4d(distortion[0], distortion[1], distortion[2], distortion[3]));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto pixel = model.Project({points[i].x, points[i].y, points[i].z});
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x(), pixels[i].x, 1e-9);
      EXPECT_NEAR(pixel->y(), pixels[i].y, 1e-9);
    }
  }
}

class AnyLens : public ::testing::TestWithParam<LensModel> {
 protected:
  const CameraModel model_{
      GetParam() == LensModel::kRadtan ? Camera(kSome) : Camera(kFisheye, LensModel::kEquidistant)};
};

INSTANTIATE_TEST_SUITE_P(CameraModel, AnyLens,
                         ::testing::Values(LensModel::kRadtan, LensModel::kEquidistant),
                         [](const auto& test) { return LensKey(test.param); });

TEST_P(AnyLens, JacobianMatchesDifferences) {
  RandomStream random(2, "camera");
  const CameraModel& model = model_;
  for (int i = 0; i < 200; ++i) {
    const double z = random.Uniform(0.5, 10.0);
    const double x = random.Uniform(-0.8, 0.8) * z;
    const double y = random.Uniform(-0.6, 0.6) * z;
    const Eigen::Vector3d point(x, y, z);
    const auto projected = model.ProjectWithJacobian(point);
    ASSERT_TRUE(projected);
    EXPECT_EQ(projected->pixel, *model.Project(point));
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector2d numeric = testing::NumericDerivative(
          [&](double by) -> Eigen::Vector2d {
            return *model.Project(point + by * Eigen::Vector3d::Unit(axis));
          },
          0.0);
      EXPECT_LT((projected->by_point.col(axis) - numeric).norm(),
                1e-6 * (1.0 + projected->by_point.norm()));
    }
    // A shift across the axis moves the pixel by as much on z = 1, over z.
    const Eigen::Matrix2d by_ideal = model.PixelByIdeal({x / z, y / z});
    EXPECT_LT((by_ideal / z - projected->by_point.leftCols<2>()).norm(), 1e-9 * by_ideal.norm());
  }
}

TEST_P(AnyLens, OnItsAxisTheJacobianIsThatOfAPinhole) {
  const auto projected =
      CameraModel(Camera({}, GetParam())).ProjectWithJacobian(Eigen::Vector3d(0.0, 0.0, 2.0));
  ASSERT_TRUE(projected);
  Eigen::Matrix<double, 2, 3> expected;
  expected << 575.3 / 2.0, 0.0, 0.0, 0.0, 574.6 / 2.0, 0.0;
  EXPECT_LT((projected->by_point - expected).norm(), 1e-12);
}

TEST_P(AnyLens, UnprojectInvertsProject) {
  const CameraModel& model = model_;
  for (int v = -20; v <= 620; v += 40) {
    for (int u = -20; u <= 820; u += 40) {
      const auto point = model.Unproject({u, v});
      ASSERT_TRUE(point);
      const auto pixel = model.Project({3.0 * point->x(), 3.0 * point->y(), 3.0});
      ASSERT_TRUE(pixel);
      EXPECT_LT((*pixel - Eigen::Vector2d(u, v)).norm(), 1e-9);
    }
  }
}

// Pixels up to 85 degrees off the axis, the last one at tan(85 degrees) = 11.43; none beyond.
TEST(CameraModel, AFisheyeIsInvertedUpTo85Degrees) {
  const CameraModel model(Camera({}, LensModel::kEquidistant));
  for (double degrees = 0.0; degrees < 85.0; degrees += 0.5) {
    const double t = degrees * M_PI / 180.0;
    const auto point = model.Unproject({399.4 + t * 575.3, 288.3});
    ASSERT_TRUE(point) << degrees;
    EXPECT_NEAR(point->x(), std::tan(t), 1e-12 * (1.0 + std::pow(std::tan(t), 2.0)));
  }
  EXPECT_FALSE(model.Unproject({399.4 + 85.01 * M_PI / 180.0 * 575.3, 288.3}));
  EXPECT_FALSE(model.Unproject({399.4, 288.3 - 3.2 * 574.6}));
}

TEST_P(AnyLens, BehindTheCameraIsNoPixel) {
  const CameraModel& model = model_;
  EXPECT_FALSE(model.Project({0.1, 0.1, 0.0}));
  EXPECT_FALSE(model.Project({0.1, 0.1, -1.0}));
  EXPECT_FALSE(model.ProjectWithJacobian({0.1, 0.1, 0.0}));
}

TEST(CameraModel, BeyondTheFoldThereIsNoRay) {
  // With k1 alone the distorted radius has a maximum of 0.96 at r = 1.44.
  EXPECT_FALSE(CameraModel(Camera({-0.16, 0.0, 0.0, 0.0})).Unproject({399.4 + 1.0 * 575.3, 288.3}));
}

// With k1 = -1/3 alone t (1 - t^2 / 3) has its maximum of 2/3 at t = 1, where its slope is 0.
TEST(CameraModel, BeyondAFisheyesFoldThereIsNoRay) {
  const CameraModel model(Camera({-1.0 / 3.0, 0.0, 0.0, 0.0}, LensModel::kEquidistant));
  const auto inside = model.Unproject({399.4 + 0.66 * 575.3, 288.3});
  ASSERT_TRUE(inside);
  const double t = std::atan(inside->x());
  EXPECT_NEAR(t * (1.0 - t * t / 3.0), 0.66, 1e-12);
  EXPECT_LT(t, 1.0);
  EXPECT_FALSE(model.Unproject({399.4 + 0.6667 * 575.3, 288.3}));
}

TEST(CameraModel, TheImageEndsHalfAPixelOutside) {
  const CameraModel model(Camera(kSome));
  EXPECT_TRUE(model.IsInside({-0.5, 599.5}));
  EXPECT_FALSE(model.IsInside({-0.6, 300.0}));
  EXPECT_FALSE(model.IsInside({300.0, 599.6}));
}

}  // namespace
}  // namespace drydock
