#include "estimator/svin2/odometry/svin2_config.h"

#include "estimator/svin2/frontend/feature_tracker_yaml.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::svin2 {
namespace {

void ReadWindow(YamlReader& reader, WindowConfig& window) {
  const auto integer = [&](const char* key, double low, double high, int value) {
    return static_cast<int>(reader.Integer(key, {low, high}, value));
  };
  window.keyframes = integer("keyframes", 1, 50, window.keyframes);
  window.recent_frames = integer("recent_frames", 2, 20, window.recent_frames);
  window.solver.iterations = integer("iterations", 1, 100, window.solver.iterations);
  if (reader.Has("solver_time_s"))
    window.solver.seconds = reader.Real("solver_time_s", Bounds::Positive());
  reader.Skip("solver_time_s");  // Also where it is missing: messages list it among the known keys.
  window.cauchy_scale = reader.Real("cauchy_scale", Bounds::Positive(), window.cauchy_scale);
  window.max_reprojection_chi2 =
      reader.Real("max_reprojection_chi2", Bounds::Positive(), window.max_reprojection_chi2);
}

void ReadHabit(YamlReader& reader, SwimmingHabit::Config& habit) {
  habit.memory_s = reader.Real("memory_s", Bounds::Positive(), habit.memory_s);
  habit.sigma = reader.Real("sigma_m_s", Bounds::NotNegative(), habit.sigma);
  habit.correlation_s = reader.Real("correlation_s", Bounds::Positive(), habit.correlation_s);
}

}  // namespace

Svin2Config ReadSvin2Config(YamlReader& reader, const Svin2Config& defaults) {
  Svin2Config config = defaults;
  config.use_sonar = reader.Boolean("use_sonar", config.use_sonar);
  config.use_depth = reader.Boolean("use_depth", config.use_depth);
  config.imu_noise_inflation =
      reader.Real("imu_noise_inflation", {0.1, 100.0}, config.imu_noise_inflation);
  reader.OptionalMap("frontend",
                     [&](YamlReader& frontend) { config.frontend = ReadFeatureTracker(frontend); });
  reader.OptionalMap("initialiser", [&](YamlReader& initialiser) {
    config.initialiser = ReadInitialiserConfig(initialiser);
  });
  reader.OptionalMap("window", [&](YamlReader& window) { ReadWindow(window, config.window); });
  reader.OptionalMap("habit", [&](YamlReader& habit) { ReadHabit(habit, config.habit); });
  return config;
}

Svin2Config ReadSvin2Config(const YamlNode& options, const Svin2Config& defaults) {
  return ReadYaml(options, [&](YamlReader& reader) { return ReadSvin2Config(reader, defaults); });
}

}  // namespace drydock::svin2
