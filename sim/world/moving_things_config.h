// What swims through a dive, as a scenario describes it.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "sensors_models/base/yaml_reader.h"

namespace drydock::sim {

/// Fish that swim together around a point.
struct ShoalConfig {
  std::string kind = "bream";
  int count = 1;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< In W.
  double radius_m = 2.0;   ///< No fish's middle leaves this ball; at least 2 size_m.
  double speed_m_s = 0.4;  ///< Mean over the fish. Those farther outside swim up to a fifth faster.
  double size_m = 0.3;     ///< Mean length; single ones are up to 15 % longer or shorter.
};

/// The kinds of fish there are.
std::vector<std::string> FishKinds();

/// The diver's own arm, which reaches into the view.
struct DiverArmConfig {
  bool left = false;
  double reach_m = 0.5;  ///< How far ahead of I its finger tips are.
};

struct MovingThingConfig {
  std::variant<ShoalConfig, DiverArmConfig> what;
  /// It is there from then to then. Fish appear and vanish; an arm is stretched out and drawn back.
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
};

/// Reads one mapping of a scenario's list `moving`; InputError names file and line.
MovingThingConfig ReadMovingThing(YamlReader& yaml);

}  // namespace drydock::sim
