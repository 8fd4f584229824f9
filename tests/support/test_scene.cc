#include "tests/support/test_scene.h"

#include <fmt/format.h>

#include "sensors_models/base/files.h"

namespace drydock::testing {

std::filesystem::path WriteScene(const std::filesystem::path& folder,
                                 const std::string& worldbody) {
  const auto path = folder / "scene.xml";
  WriteFileAtomically(path, fmt::format(R"(<mujoco>
  <compiler angle="degree"/>
  <asset>
    <texture name="marker" type="2d" builtin="gradient" rgb1="1 1 1" rgb2="0 0 0" width="256" height="256"/>
    <material name="marker" texture="marker"/>
  </asset>
  <worldbody>{}</worldbody>
</mujoco>
)",
                                        worldbody));
  return path;
}

std::string MarkerElement(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                          double half_size) {
  return fmt::format(
      R"(<geom type="plane" pos="{} {} {}" zaxis="{} {} {}" size="{} {} 0.01" material="marker"/>)",
      centre.x(), centre.y(), centre.z(), normal.x(), normal.y(), normal.z(), half_size, half_size);
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
