#include "tests/support/test_scene.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "sensors_models/base/files.h"

namespace drydock::testing {

std::filesystem::path WriteScene(const std::filesystem::path& folder, const std::string& worldbody,
                                 const std::string& assets) {
  const auto path = folder / "scene.xml";
  WriteFileAtomically(path, fmt::format(R"(<mujoco>
  <compiler angle="degree"/>
  <asset>
    <texture name="marker" type="2d" builtin="gradient" rgb1="1 1 1" rgb2="0 0 0" width="256" height="256"/>
    <material name="marker" texture="marker"/>
    {}
  </asset>
  <worldbody>{}</worldbody>
</mujoco>
)",
                                        assets, worldbody));
  return path;
}

std::string MarkerElement(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                          double half_size) {
  return fmt::format(
      R"(<geom type="plane" pos="{} {} {}" zaxis="{} {} {}" size="{} {} 0.01" material="marker"/>)",
      centre.x(), centre.y(), centre.z(), normal.x(), normal.y(), normal.z(), half_size, half_size);
}

namespace {

constexpr int kAround = 256;  ///< Corners of a circle.

/// A surface of revolution about z through the given points (radius, height), from the lower to the
/// upper end of the axis.
std::string RevolvedMesh(const std::string& name, const std::vector<Eigen::Vector2d>& profile) {
  std::string vertices, faces;
  for (const Eigen::Vector2d& point : profile) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      vertices += fmt::format("{:.7f} {:.7f} {:.7f} ", point.x() * std::cos(angle),
                              point.x() * std::sin(angle), point.y());
    }
  }
  for (int ring = 0; ring + 1 < static_cast<int>(profile.size()); ++ring) {
    for (int k = 0; k < kAround; ++k) {
      const int a = ring * kAround + k, b = ring * kAround + (k + 1) % kAround;
      faces += fmt::format("{} {} {} {} {} {} ", a, b, b + kAround, a, b + kAround, a + kAround);
    }
  }
  return fmt::format(R"(<mesh name="{}" vertex="{}" face="{}"/>)", name, vertices, faces);
}

}  // namespace

std::string BallMesh(const std::string& name, double radius) {
  constexpr double kPole = 1e-3;  // Rings at the poles have a size: no triangle is a mere line.
  std::vector<Eigen::Vector2d> profile;
  for (int k = 0; k <= kAround / 2; ++k) {
    const double angle = kPole + (std::numbers::pi - 2.0 * kPole) * k / (kAround / 2.0);
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  return RevolvedMesh(name, profile);
}

std::string DrumMesh(const std::string& name, double radius, double half_height) {
  return RevolvedMesh(name, {{1e-3 * radius, -half_height},
                             {radius, -half_height},
                             {radius, half_height},
                             {1e-3 * radius, half_height}});
}

std::string MeshElement(const std::string& name, const Eigen::Vector3d& position) {
  // Nothing collides with it: MuJoCo need not look for its convex hull, which takes seconds.
  return fmt::format(
      "<body name=\"{}\" pos=\"{} {} {}\"><geom type=\"mesh\" mesh=\"{}\" contype=\"0\" "
      "conaffinity=\"0\"/></body>",
      name, position.x(), position.y(), position.z(), name);
}

std::string BoxElement(const std::string& name, const Eigen::Vector3d& centre,
                       const Eigen::Vector3d& half_size, double yaw_deg) {
  return fmt::format(
      "<body name=\"{}\" pos=\"{} {} {}\" euler=\"0 0 {}\"><geom type=\"box\" size=\"{} {} {}\" "
      "rgba=\"1 1 1 1\"/></body>",
      name, centre.x(), centre.y(), centre.z(), yaw_deg, half_size.x(), half_size.y(),
      half_size.z());
}

}  // namespace drydock::testing
