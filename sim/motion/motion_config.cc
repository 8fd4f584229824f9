#include "sim/motion/motion_config.h"

#include <numbers>

#include <fmt/format.h>

namespace drydock::sim {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr Bounds kCoordinate{-1000.0, 1000.0};

Waypoint ReadWaypoint(YamlReader& yaml, std::size_t index) {
  Waypoint waypoint;
  waypoint.place = fmt::format("{}: motion.waypoints.{}", yaml.PlaceOf("position_m"), index);
  waypoint.position = yaml.Vector3("position_m", kCoordinate);
  if (yaml.Has("look_at_m")) {
    waypoint.look_at = yaml.Vector3("look_at_m", kCoordinate);
    if ((*waypoint.look_at - waypoint.position).head<2>().norm() < 0.1) {
      yaml.Fail("look_at_m", "a point at least 0.1 m aside of position_m");
    }
    if (yaml.Has("yaw_offset_deg") || yaml.Has("pitch_deg")) {
      yaml.Fail("look_at_m", "alone, without yaw_offset_deg and pitch_deg");
    }
  }
  waypoint.yaw_offset_rad = kRadiansPerDegree * yaml.Real("yaw_offset_deg", {-180.0, 180.0}, 0.0);
  waypoint.pitch_rad = kRadiansPerDegree * yaml.Real("pitch_deg", {-80.0, 80.0}, 0.0);
  return waypoint;
}

}  // namespace

MotionConfig ReadMotion(YamlReader& yaml) {
  MotionConfig config;
  config.rest_s = yaml.Real("rest_s", {0.0, 1000.0}, config.rest_s);
  config.speed_m_s = yaml.Real("speed_m_s", {0.01, 3.0}, config.speed_m_s);
  config.clearance_m = yaml.Real("clearance_m", {0.0, 10.0}, config.clearance_m);
  yaml.OptionalMap("sway", [&](YamlReader& sway) {
    config.sway.position_m = sway.Real("position_m", {0.0, 1.0}, 0.0);
    config.sway.angle_rad = kRadiansPerDegree * sway.Real("angle_deg", {0.0, 20.0}, 0.0);
  });
  yaml.List("waypoints", [&](YamlReader& waypoint) {
    config.waypoints.push_back(ReadWaypoint(waypoint, config.waypoints.size()));
    const std::size_t n = config.waypoints.size();
    if (n < 2) return;
    const double step =
        (config.waypoints[n - 1].position - config.waypoints[n - 2].position).norm();
    if (step < 0.01) waypoint.Fail("position_m", "at least 0.01 m from the way-point before");
  });
  if (config.waypoints.size() < 2 || config.waypoints.size() > 1000) {
    yaml.Fail("waypoints", "a list of 2 to 1000 way-points");
  }
  return config;
}

}  // namespace drydock::sim
