#include "estimator/registry/registry.h"

#include <array>
#include <string>

#include "estimator/dead_reckoning/dead_reckoning.h"
#include "estimator/svin2/odometry/svin2.h"
#include "estimator/svin2/slam/svin2_slam.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock {
namespace {

std::unique_ptr<Estimator> MakeDeadReckoning(const Rig& rig, const YamlNode& options) {
  YamlReader(options).Finish();  // There is nothing to choose.
  return std::make_unique<DeadReckoning>(rig);
}

std::unique_ptr<Estimator> MakeSvin2(const Rig& rig, const YamlNode& options, bool use_sonar,
                                     bool use_depth) {
  svin2::Svin2Config defaults;
  defaults.use_sonar = use_sonar;
  defaults.use_depth = use_depth;
  return svin2::MakeSvin2(rig, svin2::ReadSvin2Config(options, defaults));
}

std::unique_ptr<Estimator> MakeSvin2Vio(const Rig& rig, const YamlNode& options) {
  return MakeSvin2(rig, options, false, false);
}

std::unique_ptr<Estimator> MakeSvin2NoSonar(const Rig& rig, const YamlNode& options) {
  return MakeSvin2(rig, options, false, true);
}

std::unique_ptr<Estimator> MakeSvin2NoDepth(const Rig& rig, const YamlNode& options) {
  return MakeSvin2(rig, options, true, false);
}

std::unique_ptr<Estimator> MakeSvin2NoLoop(const Rig& rig, const YamlNode& options) {
  return MakeSvin2(rig, options, true, true);
}

/// Less than half of the 67 ms between frames: the front end needs time too.
constexpr std::string_view kSvin2OnRobot = "{window: {solver_time_s: 0.03}}";

constexpr std::array kEstimators = {
    EstimatorEntry{"dead-reckoning", "IMU integrated from the true start, height held by pressure",
                   MakeDeadReckoning, "{}"},
    EstimatorEntry{"svin2-vio", "SVIn2 with stereo and IMU alone", MakeSvin2Vio, kSvin2OnRobot},
    EstimatorEntry{"svin2-nosonar", "SVIn2 without sonar and loop closing", MakeSvin2NoSonar,
                   kSvin2OnRobot},
    EstimatorEntry{"svin2-nodepth", "SVIn2 without pressure and loop closing", MakeSvin2NoDepth,
                   kSvin2OnRobot},
    EstimatorEntry{"svin2-noloop", "SVIn2 without loop closing", MakeSvin2NoLoop, kSvin2OnRobot},
    EstimatorEntry{"svin2", "SVIn2: sonar, vision, inertia, depth and loop closing",
                   svin2::MakeSvin2Slam, kSvin2OnRobot},
};

}  // namespace

std::span<const EstimatorEntry> Estimators() { return kEstimators; }

YamlNode NoOptions() {
  YamlNode options;
  options.kind = YamlNode::Kind::kMap;
  return options;
}

YamlNode OnRobot(const EstimatorEntry& entry, const YamlNode& options) {
  YamlNode merged = ParseYaml(entry.on_robot, "options on a robot");
  MergeYaml(merged, options);
  return merged;
}

const EstimatorEntry& FindEstimator(std::string_view name) {
  std::string known;
  for (const EstimatorEntry& entry : kEstimators) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError(fmt::format("estimator is {}, must be one of {}", name, known));
}

}  // namespace drydock
