// Everything that SVIn2 can be told, in part by options (docs/scenarios.md).
#pragma once

#include "estimator/svin2/frontend/feature_tracker.h"
#include "estimator/svin2/initialisation/initialiser_config.h"
#include "estimator/svin2/odometry/depth_gate.h"
#include "estimator/svin2/odometry/sonar_link.h"
#include "estimator/svin2/odometry/swimming_habit.h"
#include "estimator/svin2/odometry/tracking_monitor.h"
#include "estimator/svin2/window/sliding_window.h"
#include "sensors_models/base/yaml_node.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::svin2 {

struct Svin2Config {
  bool use_sonar = true;
  bool use_depth = true;
  /// What is believed of the IMU's noise, as a multiple of its sheet. For an IMU whose sheet leaves
  /// out scale errors, misalignment or vibration, more than 1.
  double imu_noise_inflation = 1.0;
  FeatureTracker::Config frontend;
  InitialiserConfig initialiser;
  WindowConfig window;
  StartSigmas start;  ///< Of a state that was found or told.
  SonarConfig sonar;
  DepthGate::Config depth_gate;
  TrackingMonitor::Config tracking;
  SwimmingHabit::Config habit;    ///< What is expected of a body that is lost.
  bool report_keyframes = false;  ///< For loop closing; costs a covariance at each keyframe.
};

/// Reads `options` over `defaults`, strictly: InputError with file, line and key. `frontend` and
/// `initialiser`, where they are given, are read over their own defaults.
Svin2Config ReadSvin2Config(const YamlNode& options, const Svin2Config& defaults);
/// The same, where the mapping holds more.
Svin2Config ReadSvin2Config(YamlReader& reader, const Svin2Config& defaults);

}  // namespace drydock::svin2
