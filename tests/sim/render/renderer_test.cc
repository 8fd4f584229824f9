#include "sim/render/renderer.h"

#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/models/camera_model.h"
#include "sim/render/lens.h"
#include "sim/world/ray_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using testing::BoxElement;
using testing::MarkerElement;
using testing::TemporaryFolder;
using testing::WriteScene;

const Eigen::Quaterniond kCameraInBody(0.5, -0.5, 0.5, -0.5);

enum class Distortion { kNone, kRadtan, kEquidistant };

CameraIntrinsics Camera(Distortion distortion) {
  CameraIntrinsics camera;
  camera.width = 800;
  camera.height = 600;
  camera.fx = 575.3;
  camera.fy = 574.6;
  camera.cx = 399.4;
  camera.cy = 288.3;  // Well off the centre.
  if (distortion == Distortion::kRadtan) camera.distortion = {-0.16, 0.102, 0.001, -0.0007};
  if (distortion == Distortion::kEquidistant) {
    camera.lens = LensModel::kEquidistant;
    camera.distortion = {-0.013, 0.021, -0.012, 0.0024};
  }
  return camera;
}

/// Mean position of what is brighter than half, within `radius` px of `where`, weighted by
/// brightness.
Eigen::Vector2d Centroid(const cv::Mat& grey, const Eigen::Vector2d& where, int radius) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int v = static_cast<int>(where.y()) - radius; v <= where.y() + radius; ++v) {
    for (int u = static_cast<int>(where.x()) - radius; u <= where.x() + radius; ++u) {
      if (u < 0 || v < 0 || u >= grey.cols || v >= grey.rows) continue;
      // Cubed, so that the hard edge of the square, where MuJoCo's gradient is not quite black, has
      // no say.
      const double weight = std::pow(grey.at<float>(v, u), 3.0);
      sum += weight * Eigen::Vector3d(u, v, 1.0);
    }
  }
  return sum.head<2>() / sum.z();
}

class MarkerTest : public ::testing::TestWithParam<Distortion> {};

// Shows that frames, intrinsics, the off-centre frustum, the flipped rows and the lens are right:
// from a turned rig, in both eyes, markers are seen where the model puts them.
TEST_P(MarkerTest, MarkersAreSeenWhereTheModelPutsThem) {
  const CameraModel model(Camera(GetParam()));
  const Lens lens(Camera(GetParam()));
  const Pose T_WI(FromYawPitchRoll(0.7, -0.2, 0.3), {3.0, -2.0, 1.5});
  std::vector<Eigen::Vector3d> markers_W;
  std::string elements;
  constexpr double kHalfSize = 0.03;
  for (const double x : {-0.55, -0.3, 0.0, 0.25, 0.55}) {
    for (const double y : {-0.4, -0.1, 0.2, 0.42}) {
      const double z = 1.4 + 0.3 * std::sin(7.0 * x + 3.0 * y);
      markers_W.push_back(T_WI * (kCameraInBody * Eigen::Vector3d(x * z, y * z, z)));
      elements += MarkerElement(markers_W.back(), T_WI.p() - markers_W.back(), kHalfSize);
    }
  }
  const TemporaryFolder folder;
  World world(WriteScene(folder.path(), elements));
  Renderer renderer(world, RendererBackend::kAuto, lens.source().width, lens.source().height);
  int seen = 0;
  double worst = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p_IC :
       {Eigen::Vector3d(0.04, 0.084, -0.005), Eigen::Vector3d(0.039, -0.059, -0.007)}) {
    const Pose T_WC = T_WI * Pose(kCameraInBody, p_IC);
    RawImage raw;
    renderer.Render(T_WC, lens.source(), raw);
    cv::Mat red(raw.albedo.size(), CV_32FC1), image;
    for (int v = 0; v < red.rows; ++v) {
      for (int u = 0; u < red.cols; ++u) {
        red.at<float>(v, u) = static_cast<float>(raw.albedo.at<cv::Vec3b>(v, u)[0]) / 255.F;
      }
    }
    lens.ApplySmooth(red, image);
    for (const Eigen::Vector3d& marker : markers_W) {
      const Eigen::Vector3d p_C = T_WC.Inverse() * marker;
      const auto pixel = model.Project(p_C);
      if (!pixel || pixel->x() < 15 || pixel->y() < 15 || pixel->x() > 784 || pixel->y() > 584)
        continue;
      const Eigen::Vector2d error = Centroid(image, *pixel, 15) - *pixel;
      worst = std::max(worst, error.norm());
      mean += error;
      ++seen;
    }
  }
  RecordProperty("worst_px", std::to_string(worst));
  std::printf("markers seen: %d, worst error: %.3f px, mean: (%.3f, %.3f) px\n", seen, worst,
              mean.x() / seen, mean.y() / seen);
  EXPECT_GE(seen, 30);
  EXPECT_LT(worst, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Lenses, MarkerTest,
                         ::testing::Values(Distortion::kNone, Distortion::kRadtan,
                                           Distortion::kEquidistant),
                         [](const auto& test) {
                           if (test.param == Distortion::kNone) return "None";
                           return test.param == Distortion::kRadtan ? "Radtan" : "Equidistant";
                         });

TEST(Renderer, DepthAgreesWithEmbree) {
  const TemporaryFolder folder;
  World world(WriteScene(folder.path(),
                         BoxElement("wall", {5.3, 0.0, 0.0}, {0.2, 6.0, 6.0}, 20.0) +
                             BoxElement("near", {1.5, 0.3, 0.1}, {0.2, 0.2, 0.2}, 35.0) +
                             BoxElement("middle", {3.0, -0.8, -0.5}, {0.4, 0.3, 0.3}, -15.0)));
  const RayScene rays(world);
  const Pinhole pinhole{800, 600, 575.0, 390.2, 310.7};
  const Pose T_WC = Pose(FromYawPitchRoll(0.05, 0.02, 0.1), {0.0, 0.0, 0.0}) *
                    Pose(kCameraInBody, {0.0, 0.0, 0.0});
  Renderer renderer(world, RendererBackend::kAuto, 800, 600);
  RawImage raw;
  renderer.Render(T_WC, pinhole, raw);
  int compared = 0, edges = 0;
  double worst = 0.0;
  for (int v = 0; v < 600; v += 7) {
    for (int u = 0; u < 800; u += 7) {
      const Eigen::Vector3d ray((u - pinhole.cx) / pinhole.focal, (v - pinhole.cy) / pinhole.focal,
                                1.0);
      const auto hit = rays.Cast(T_WC.p(), T_WC.q() * ray.normalized(), 50.0);
      const double depth = raw.depth.at<float>(v, u);
      ASSERT_EQ(hit.has_value(), std::isfinite(depth)) << u << ", " << v;
      if (!hit) continue;
      const double error = std::abs(depth * ray.norm() - hit->range);
      // A ray that grazes an edge may fall on either side of it.
      if (error > 0.05) {
        ++edges;
        continue;
      }
      worst = std::max(worst, error * 25.0 / std::max(25.0, hit->range * hit->range));
      ++compared;
    }
  }
  std::printf("compared: %d, edges: %d, worst at 5 m: %.6f m\n", compared, edges, worst);
  EXPECT_GT(compared, 8000);
  EXPECT_LT(edges, 10);
  EXPECT_LT(worst, 0.005);
}

TEST(Renderer, CullingChangesNothingThatIsSeen) {
  const TemporaryFolder folder;
  std::string elements;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 40.0;
    elements += BoxElement("box" + std::to_string(i),
                           {4.0 * std::cos(angle), 4.0 * std::sin(angle), 0.3 * (i % 5)},
                           {0.25, 0.1, 0.3}, 17.0 * i);
  }
  World world(WriteScene(folder.path(), elements));
  const RayScene rays(world);
  const Pinhole pinhole{400, 300, 287.0, 195.0, 160.0};
  Renderer renderer(world, RendererBackend::kAuto, 400, 300);
  int wrong = 0;
  for (int look = 0; look < 12; ++look) {
    const Pose T_WC =
        Pose(FromYawPitchRoll(0.55 * look, 0.2 * std::sin(look), 0.1), {0.3, 0.2, 0.4}) *
        Pose(kCameraInBody, {0.0, 0.0, 0.0});
    RawImage raw;
    renderer.Render(T_WC, pinhole, raw);
    for (int v = 0; v < 300; v += 5) {
      for (int u = 0; u < 400; u += 5) {
        const Eigen::Vector3d ray((u - pinhole.cx) / pinhole.focal,
                                  (v - pinhole.cy) / pinhole.focal, 1.0);
        const auto hit = rays.Cast(T_WC.p(), T_WC.q() * ray.normalized(), 50.0);
        if (hit.has_value() != std::isfinite(raw.depth.at<float>(v, u))) ++wrong;
      }
    }
  }
  EXPECT_LE(wrong, 12);  // Rays that graze an edge.
}

TEST(Renderer, NothingIsSeenBeyondTheFarPlane) {
  const TemporaryFolder folder;
  // Faces at 2 m and at 6 m, the far one around the near one.
  World world(WriteScene(folder.path(), BoxElement("near", {2.5, 0.0, 0.0}, {0.5, 0.5, 0.5}) +
                                            BoxElement("far", {6.5, 0.0, 0.0}, {0.5, 4.0, 4.0})));
  const Pinhole pinhole{320, 240, 230.0, 159.5, 119.5};
  Renderer renderer(world, RendererBackend::kAuto, 320, 240);
  RawImage raw;
  const auto look = [&](double far_m) {
    renderer.SetFar(far_m);
    renderer.Render(Pose(kCameraInBody, {0, 0, 0}), pinhole, raw);
  };
  look(6.1);
  EXPECT_NEAR(raw.depth.at<float>(120, 160), 2.0, 1e-4);
  EXPECT_NEAR(raw.depth.at<float>(120, 20), 6.0, 1e-4);
  for (const double far_m : {5.9, 6.0 - 1e-3}) {
    look(far_m);
    EXPECT_NEAR(raw.depth.at<float>(120, 160), 2.0, 1e-4);
    EXPECT_TRUE(std::isinf(raw.depth.at<float>(120, 20)));
    EXPECT_EQ(raw.albedo.at<cv::Vec3b>(120, 20), cv::Vec3b(0, 0, 0));
  }
  EXPECT_THROW(renderer.SetFar(Renderer::kNear), std::exception);
  EXPECT_THROW(renderer.SetFar(1.01 * Renderer::kFar), std::exception);
}

TEST(Renderer, SameBytesTwice) {
  const TemporaryFolder folder;
  World world(WriteScene(folder.path(), BoxElement("box", {2.0, 0.0, 0.0}, {0.3, 0.3, 0.3}, 25.0)));
  const Pinhole pinhole{320, 240, 230.0, 159.5, 119.5};
  Renderer renderer(world, RendererBackend::kAuto, 320, 240);
  RawImage first, second;
  renderer.Render(Pose(kCameraInBody, {0, 0, 0}), pinhole, first);
  renderer.Render(Pose(kCameraInBody, {0, 0, 0.5}), pinhole, second);
  renderer.Render(Pose(kCameraInBody, {0, 0, 0}), pinhole, second);
  EXPECT_EQ(0, std::memcmp(first.albedo.data, second.albedo.data, first.albedo.total() * 3));
  EXPECT_EQ(0, std::memcmp(first.depth.data, second.depth.data, first.depth.total() * 4));
}

TEST(Renderer, UnknownBackendIsNamed) {
  EXPECT_EQ(ParseRendererBackend("osmesa"), RendererBackend::kOsmesa);
  EXPECT_THROW(ParseRendererBackend("vulkan"), InputError);
}

}  // namespace
}  // namespace drydock::sim
