// How a scenario describes a dive's motion.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

/// A point of the path and where the rig looks there.
struct Waypoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Of I [m], in W.
  /// Look at this point [m, in W]; otherwise along the path.
  std::optional<Eigen::Vector3d> look_at;
  double yaw_offset_rad = 0.0;  ///< Added to the direction of travel, positive to the left.
  double pitch_rad = 0.0;       ///< Positive looks down. Ignored with look_at.
  std::string place;            ///< Where it was written: "file:line: key"; for messages.
};

/// Root mean square of the sway; the YAML keys are position_m and angle_deg.
struct SwayConfig {
  double position_m = 0.0;
  double angle_rad = 0.0;
};

struct MotionConfig {
  double rest_s = 0.0;       ///< At the first way-point, without sway, before it swims.
  double speed_m_s = 0.45;   ///< Along the path; the dive starts and ends at rest.
  double clearance_m = 0.3;  ///< The body must stay this far from everything.
  SwayConfig sway;
  std::vector<Waypoint> waypoints;  ///< At least two.
};

/// Reads the `motion` mapping of a scenario; InputError names file and line.
MotionConfig ReadMotion(YamlReader& yaml);

}  // namespace drydock::sim
