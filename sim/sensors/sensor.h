// What every simulated sensor is to the suite. To add one: its file, and a line in sensor_suite.cc.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <variant>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/time.h"
#include "sensors_models/measurement/measurement.h"

namespace drydock::sim {

/// What the IMU's biases were when it said what it said.
struct ImuTruth {
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();   ///< [rad/s]
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();  ///< [m/s^2]
};

/// What the axis of the sonar's beam really hit.
struct SonarTruth {
  double range = 0.0;  ///< [m]; 0 if nothing was within the sonar's reach.
  std::string body;    ///< Name of the body hit; empty if none.
};

/// What each eye's pixels really saw, if depth images were asked for.
struct StereoTruth {
  std::array<cv::Mat, 2>
      depth;  ///< CV_32FC1, along the optical axis [m], +infinity where nothing is.
};

/// A measurement and what the simulator knows beyond it. Estimators get the measurement only.
struct Observation {
  Measurement measurement;
  std::variant<std::monostate, ImuTruth, SonarTruth, StereoTruth> truth;
};

class Sensor {
 public:
  virtual ~Sensor() = default;
  /// When the next measurement is due.
  virtual Time NextTime() const = 0;
  /// Takes it. t_arrival is left to the suite.
  virtual Observation Observe() = 0;
};

}  // namespace drydock::sim
