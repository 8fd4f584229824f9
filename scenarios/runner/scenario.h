// What a scenario file says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/registry/registry.h"
#include "scenarios/scoring/criteria.h"
#include "sensors_models/base/time.h"
#include "sensors_models/base/yaml_node.h"
#include "sensors_models/measurement/rig.h"
#include "sim/motion/motion_config.h"
#include "sim/optics/lamp_config.h"
#include "sim/optics/water_config.h"
#include "sim/sensors/sensors_config.h"
#include "sim/world/moving_things_config.h"

namespace drydock {

struct SceneChoice {
  std::string name;
  std::uint64_t seed = 1;  ///< Of geometry and textures; not touched by the scenario's seed.
};

struct EstimatorChoice {
  std::string name = "svin2";
  /// What the estimator believes of the rig: a rig's name or file; by default the true one.
  std::string rig;
  YamlNode rig_set;  ///< What it believes otherwise: {stereo.rate_hz: 10}.
  bool start_from_truth = false;
  YamlNode options = NoOptions();  ///< A mapping that the estimator itself understands.
};

/// One dive: what is there, how it is swum, what is measured, who estimates and what counts as
/// good.
struct Scenario {
  std::string name;     ///< The file's name without .yaml.
  std::string summary;  ///< One line.
  SceneChoice scene;
  std::string rig;  ///< The true rig: a name or a file.
  sim::WaterConfig water;
  std::vector<sim::LampConfig> lamps;  ///< On the body.
  sim::SensorsConfig sensors;
  sim::MotionConfig motion;
  std::vector<sim::MovingThingConfig> moving;  ///< What swims through it.
  EstimatorChoice estimator;
  std::uint64_t seed = 1;            ///< Of noise, biases, sway and what moves.
  std::optional<double> duration_s;  ///< Cuts the dive.
  std::vector<score::Criterion> criteria;

  /// The file as it was understood: inherited and overridden keys in place.
  YamlNode resolved;
};

/// Reads a scenario with the files it is based on, then applies `overrides` ("key.path=value"). The
/// file must be valid before and after. InputError with file, line, key, value and what is allowed.
Scenario LoadScenario(const std::filesystem::path& path,
                      const std::vector<std::string>& overrides = {});

/// The estimator, not started, with the rig and the options that are chosen. InputError where one
/// of them cannot be used.
std::unique_ptr<Estimator> MakeEstimator(const EstimatorChoice& choice);

/// `scenario` with an estimator that has to keep up with a robot (see OnRobot).
Scenario WithEstimatorOnRobot(const Scenario& scenario);

/// Reads a whole scenario from `root`; `name` is what reports call it.
Scenario ReadScenario(const YamlNode& root, const std::string& name);

}  // namespace drydock
