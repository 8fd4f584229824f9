#include "sim/render/flat_port.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sim/render/lens.h"

namespace drydock::sim {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

FlatPortConfig Port() {
  FlatPortConfig port;
  port.enabled = true;
  port.distance_m = 0.05;
  port.thickness_m = 0.012;
  return port;
}

/// 72 degrees wide.
CameraIntrinsics Camera() {
  CameraIntrinsics camera;
  camera.width = 240;
  camera.height = 180;
  camera.fx = 172.0;
  camera.fy = 171.5;
  camera.cx = 118.0;
  camera.cy = 92.0;
  camera.distortion = {-0.16, 0.10, 0.001, -0.002};
  return camera;
}

/// Bends a unit direction at a plane across z.
Eigen::Vector3d Refract(const Eigen::Vector3d& in, double from, double to) {
  Eigen::Vector3d out = from / to * in;
  out.z() = 0.0;
  out.z() = std::sqrt(1.0 - out.squaredNorm());
  return out;
}

/// Where the ray that leaves the camera at an angle has come to at depth z, plane by plane.
double RadiusOfRay(const FlatPortConfig& port, double angle, double z) {
  Eigen::Vector3d ray(std::sin(angle), 0.0, std::cos(angle));
  Eigen::Vector3d place = port.distance_m / ray.z() * ray;
  ray = Refract(ray, 1.0, port.glass_index);
  place += port.thickness_m / ray.z() * ray;
  ray = Refract(ray, port.glass_index, port.water_index);
  place += (z - place.z()) / ray.z() * ray;
  return place.x();
}

/// Tangent of the angle at which a point is seen behind the port, by halving.
double TracedTangent(const FlatPortConfig& port, double radius, double z) {
  double low = 0.0, high = 1.57;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (RadiusOfRay(port, middle, z) < radius ? low : high) = middle;
  }
  return std::tan(low);
}

/// Where a point at `ideal` in the plane z = 1 and at depth z appears, by the rays: where the sheet
/// has what lies on the same one at the calibration's distance.
Eigen::Vector2d Traced(const FlatPortConfig& port, const Eigen::Vector2d& ideal, double z) {
  const double tangent = TracedTangent(port, ideal.norm() * z, z);
  const double board = RadiusOfRay(port, std::atan(tangent), port.calibration_distance_m);
  return board / port.calibration_distance_m * ideal.normalized();
}

TEST(FlatPort, BendsRaysAsTheyAreTraced) {
  const double focal = 575.0;
  double most = 0.0;
  for (const double distance : {0.0, 0.02, 0.08}) {
    FlatPortConfig config = Port();
    config.distance_m = distance;
    const FlatPort port(config);
    for (const double radius : {0.05, 0.3, 0.6, 0.9}) {
      for (const double z : {0.3, 0.5, 1.0, 2.0, 5.0, 30.0}) {
        const Eigen::Vector2d ideal = radius * Eigen::Vector2d(0.6, -0.8);
        const Eigen::Vector2d traced = Traced(config, ideal, z);
        EXPECT_NEAR(focal * (port.Calibrated(ideal, 1.0 / z) - traced).norm(), 0.0, 1e-3)
            << distance << " m, " << radius << " at " << z << " m";
        // And back: what is seen where the sheet has `traced`.
        const Eigen::Vector2d seen = traced + (1.0 / z - 0.5) * port.ByInverseDepth(traced);
        EXPECT_NEAR(focal * (seen - ideal).norm(), 0.0, 1e-3);
        most = std::max(most, focal * (traced - ideal).norm());
      }
    }
  }
  EXPECT_GT(most, 20.0);  // [px]; it is not as if nothing moved.
}

// In air a ray is farther from the axis than its extension from the water would be: the nearer a
// point, the nearer to the axis it is seen, against where a calibration has it.
TEST(FlatPort, NearPointsMoveInAndFarOnesOut) {
  const FlatPort port(Port());
  double before = 0.0;
  for (const double z : {0.3, 0.6, 1.2, 2.0, 4.0, 50.0}) {
    const double seen = port.Calibrated({0.5, 0.0}, 1.0 / z).x();
    EXPECT_GT(seen, before);
    EXPECT_EQ(seen < 0.5 - 1e-9, z < 2.0);
    EXPECT_EQ(seen > 0.5 + 1e-9, z > 2.0);
    before = seen;
  }
  // Near the axis angles are as their sines: the image is in proportion to
  // z / (z + (n_w - 1) d - (1 - n_w / n_g) t).
  const auto scale = [](double z) { return z / (z + 0.333 * 0.05 - (1.0 - 1.333 / 1.5) * 0.012); };
  for (const double z : {0.4, 1.0, 10.0})
    EXPECT_NEAR(port.Calibrated({0.001, 0.0}, 1.0 / z).x() / 0.001, scale(z) / scale(2.0), 1e-6);
}

TEST(FlatPort, MovesNothingThatACalibrationHasSeen) {
  const FlatPort port(Port());
  FlatPortConfig none = Port();
  none.distance_m = none.thickness_m = 0.0;
  const FlatPort touching(none);
  for (const double radius : {0.0, 0.3, 0.9}) {
    EXPECT_NEAR(port.Calibrated({radius, 0.0}, 0.5).x(), radius, 1e-9);
    EXPECT_NEAR(touching.Calibrated({0.0, radius}, 1.0 / 0.4).y(), radius, 1e-9);
    EXPECT_EQ(touching.ByInverseDepth({0.0, radius}).norm(), 0.0);
  }
  EXPECT_EQ(port.Calibrated({0.0, 0.0}, 1.0 / 0.4).norm(), 0.0);
  EXPECT_EQ(port.ByInverseDepth({0.0, 0.0}).norm(), 0.0);
}

TEST(FlatPort, PassesNothingBeyondTotalReflection) {
  EXPECT_NEAR(FlatPort(Port()).widest(), std::tan(std::asin(1.0 / 1.333) - 0.0349066), 1e-6);
}

FlatPortConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "s.yaml"), [](YamlReader& yaml) { return ReadFlatPort(yaml); });
}

TEST(FlatPort, IsReadStrictly) {
  EXPECT_FALSE(FlatPortConfig{}.enabled);
  EXPECT_TRUE(Read("{}\n").enabled);
  const FlatPortConfig port = Read(
      "{distance_m: 0.01, thickness_m: 0.02, glass_index: 1.49, water_index: 1.34,"
      " calibration_distance_m: 1.5, enabled: false}\n");
  EXPECT_FALSE(port.enabled);
  EXPECT_EQ(port.distance_m, 0.01);
  EXPECT_EQ(port.thickness_m, 0.02);
  EXPECT_EQ(port.glass_index, 1.49);
  EXPECT_EQ(port.water_index, 1.34);
  EXPECT_EQ(port.calibration_distance_m, 1.5);
  EXPECT_THROW(Read("distance_m: -0.01\n"), InputError);
  EXPECT_THROW(Read("calibration_distance_m: 0.1\n"), InputError);
  EXPECT_THROW(Read("distance: 0.01\n"), InputError);
}

/// Where the camera behind the port sees a point.
Eigen::Vector2d Seen(const CameraModel& camera, const FlatPort& port, const Eigen::Vector3d& p_C) {
  const Eigen::Vector2d board = port.Calibrated(p_C.head<2>() / p_C.z(), 1.0 / p_C.z());
  return *camera.Project({board.x(), board.y(), 1.0});
}

// An image whose value is the pinhole's own coordinate shows where each pixel looks.
TEST(FlatPortLens, EachPixelLooksAtWhatAppearsThere) {
  const Lens lens(Camera(), Port());
  const CameraModel camera(Camera());
  const FlatPort port(Port());
  const Pinhole& source = lens.source();
  cv::Mat columns(source.height, source.width, CV_32FC1), rows = columns.clone();
  for (int v = 0; v < source.height; ++v) {
    for (int u = 0; u < source.width; ++u) {
      columns.at<float>(v, u) = static_cast<float>(u);
      rows.at<float>(v, u) = static_cast<float>(v);
    }
  }
  for (const double z : {0.3, 0.45, 1.0, 2.0, 6.0, kFar}) {
    const cv::Mat depth(columns.size(), CV_32FC1, cv::Scalar(z));
    cv::Mat column, row;
    lens.ApplySmooth(columns, depth, column);
    lens.ApplySmooth(rows, depth, row);
    for (int v = 0; v < 180; ++v) {
      for (int u = 0; u < 240; ++u) {
        const Eigen::Vector2d ideal((column.at<float>(v, u) - source.cx) / source.focal,
                                    (row.at<float>(v, u) - source.cy) / source.focal);
        const Eigen::Vector3d p_C = std::min(z, 1e9) * Eigen::Vector3d(ideal.x(), ideal.y(), 1.0);
        const Eigen::Vector2d seen = Seen(camera, port, p_C);
        ASSERT_NEAR((seen - Eigen::Vector2d(u, v)).norm(), 0.0, 0.01)
            << u << ", " << v << " at " << z << " m";
      }
    }
  }
}

TEST(FlatPortLens, IsThatWithoutPortWhereItWasCalibrated) {
  const Lens plain(Camera()), behind(Camera(), Port());
  EXPECT_GT(behind.source().width, plain.source().width);
  const auto blob = [](const Pinhole& source) {
    cv::Mat image(source.height, source.width, CV_32FC1);
    for (int v = 0; v < source.height; ++v) {
      for (int u = 0; u < source.width; ++u) {
        image.at<float>(v, u) = static_cast<float>(1.5 + std::sin(0.15 * (u - source.cx)) *
                                                             std::cos(0.1 * (v - source.cy)));
      }
    }
    return image;
  };
  cv::Mat without, with;
  plain.ApplySmooth(blob(plain.source()), without);
  const Pinhole& source = behind.source();
  const cv::Mat depth(source.height, source.width, CV_32FC1, cv::Scalar(2.0));
  behind.ApplySmooth(blob(source), depth, with);
  for (int v = 0; v < 180; ++v) {
    for (int u = 0; u < 240; ++u)
      ASSERT_NEAR(with.at<float>(v, u), without.at<float>(v, u), 1e-3) << u << ", " << v;
  }
}

/// Dots on a plane that comes from far at the left to near at the right.
struct Dots {
  cv::Mat light, depth;
  std::vector<Eigen::Vector3d> points_C;
};

double InverseDepth(const Eigen::Vector2d& ideal) {
  return 1.2 + 1.4 * ideal.x() - 0.3 * ideal.y();
}

Dots DrawDots(const Pinhole& source) {
  Dots dots;
  dots.light = cv::Mat::zeros(source.height, source.width, CV_32FC1);
  dots.depth = dots.light.clone();
  for (int v = 0; v < source.height; ++v) {
    for (int u = 0; u < source.width; ++u) {
      const Eigen::Vector2d ideal((u - source.cx) / source.focal, (v - source.cy) / source.focal);
      dots.depth.at<float>(v, u) = static_cast<float>(1.0 / std::max(InverseDepth(ideal), 0.01));
    }
  }
  for (double x = -0.6; x < 0.65; x += 0.15) {
    for (double y = -0.4; y < 0.45; y += 0.16) {
      const Eigen::Vector2d ideal(x, y);
      dots.points_C.emplace_back(Eigen::Vector3d(x, y, 1.0) / InverseDepth(ideal));
      const double column = x * source.focal + source.cx, row = y * source.focal + source.cy;
      for (int v = static_cast<int>(row) - 7; v < row + 8; ++v) {
        for (int u = static_cast<int>(column) - 7; u < column + 8; ++u) {
          dots.light.at<float>(v, u) += static_cast<float>(
              std::exp(-(std::pow(u - column, 2) + std::pow(v - row, 2)) / (2.0 * 1.5 * 1.5)));
        }
      }
    }
  }
  return dots;
}

Eigen::Vector2d Centroid(const cv::Mat& light, const Eigen::Vector2d& near) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int v = static_cast<int>(near.y()) - 7; v < near.y() + 8; ++v) {
    for (int u = static_cast<int>(near.x()) - 7; u < near.x() + 8; ++u)
      sum += light.at<float>(v, u) * Eigen::Vector3d(u, v, 1.0);
  }
  return sum.head<2>() / sum.z();
}

TEST(FlatPortLens, DotsAppearWhereTheyShould) {
  const Lens lens(Camera(), Port());
  const CameraModel camera(Camera());
  const FlatPort port(Port());
  const Dots dots = DrawDots(lens.source());
  cv::Mat seen, depth;
  lens.ApplySmooth(dots.light, dots.depth, seen);
  lens.ApplyNearest(dots.depth, depth);
  double most = 0.0;
  for (const Eigen::Vector3d& point : dots.points_C) {
    const Eigen::Vector2d expected = Seen(camera, port, point);
    EXPECT_NEAR((Centroid(seen, expected) - expected).norm(), 0.0, 0.03)
        << expected.transpose() << ", " << point.z() << " m";
    const float there = depth.at<float>(static_cast<int>(std::lround(expected.y())),
                                        static_cast<int>(std::lround(expected.x())));
    EXPECT_NEAR(1.0 / there, 1.0 / point.z(), 0.015);
    most = std::max(most, (expected - *camera.Project(point)).norm());
  }
  EXPECT_GT(most, 2.0);  // It is not as if nothing moved.
}

// A board in front of a wall. Where a pixel may see both it sees the board, and where it would see
// neither, which the picture does not have, the wall.
TEST(FlatPortLens, NearHidesFar) {
  const Lens lens(Camera(), Port());
  const CameraModel camera(Camera());
  const FlatPort port(Port());
  const Pinhole& source = lens.source();
  constexpr double kBoard = 0.6, kWall = 4.0;
  cv::Mat depth(source.height, source.width, CV_32FC1, cv::Scalar(kWall));
  const cv::Rect board(static_cast<int>(source.cx) - 70, static_cast<int>(source.cy) + 20, 100, 40);
  depth(board).setTo(kBoard);
  cv::Mat seen;
  lens.ApplyNearest(depth, seen);
  int on_board = 0, moved = 0;
  for (int v = 0; v < 180; ++v) {
    for (int u = 0; u < 240; ++u) {
      const Eigen::Vector2d calibrated = *camera.Unproject({u, v});
      const Eigen::Vector2d if_board =
          calibrated + (1.0 / kBoard - 0.5) * port.ByInverseDepth(calibrated);
      const cv::Point2d there(if_board.x() * source.focal + source.cx - board.x + 0.5,
                              if_board.y() * source.focal + source.cy - board.y + 0.5);
      const double inside =
          std::min({there.x, there.y, board.width - there.x, board.height - there.y});  // [px]
      if (std::abs(inside) < 0.1) continue;
      ASSERT_EQ(seen.at<float>(v, u), static_cast<float>(inside > 0.0 ? kBoard : kWall))
          << u << ", " << v;
      on_board += inside > 0.0 ? 1 : 0;
      const cv::Point without(
          static_cast<int>(std::lround(calibrated.x() * source.focal + source.cx)),
          static_cast<int>(std::lround(calibrated.y() * source.focal + source.cy)));
      moved += board.contains(without) != (inside > 0.0) ? 1 : 0;
    }
  }
  EXPECT_GT(on_board, 2000);
  EXPECT_GT(moved, 100);
}

// Two surfaces and nothing at all beside them.
TEST(FlatPortLens, SilhouettesDoNoHarm) {
  const Lens lens(Camera(), Port());
  const Pinhole& source = lens.source();
  cv::Mat depth(source.height, source.width, CV_32FC1,
                cv::Scalar(std::numeric_limits<float>::infinity()));
  depth.colRange(0, source.width / 2).setTo(0.06);
  depth.rowRange(0, source.height / 3).setTo(3.0);
  const cv::Mat light(source.height, source.width, CV_32FC3, cv::Scalar(1.0, 2.0, 3.0));
  cv::Mat seen, seen_depth;
  lens.ApplySmooth(light, depth, seen);
  lens.ApplyNearest(depth, seen_depth);
  ASSERT_EQ(seen.type(), CV_32FC3);
  for (int v = 0; v < 180; ++v) {
    for (int u = 0; u < 240; ++u) {
      ASSERT_NEAR(seen.at<cv::Vec3f>(v, u)[2], 3.F, 1e-4);
      const float there = seen_depth.at<float>(v, u);
      ASSERT_TRUE(there == 0.06F || there == 3.F || std::isinf(there));
    }
  }
}

TEST(FlatPortLens, NeedsDepthAndAViewThatAPortShows) {
  const Lens lens(Camera(), Port());
  const cv::Mat light(lens.source().height, lens.source().width, CV_32FC1, cv::Scalar(1.0));
  cv::Mat seen;
  EXPECT_THROW(lens.ApplySmooth(light, seen), std::logic_error);
  CameraIntrinsics wide = Camera();
  wide.fx = wide.fy = 125.0;  // 50 degrees in a corner.
  wide.distortion = {};
  EXPECT_NO_THROW(Lens{wide});
  EXPECT_THROW(Lens(wide, Port()), InputError);
}

}  // namespace
}  // namespace drydock::sim
