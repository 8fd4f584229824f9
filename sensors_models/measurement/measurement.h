// What sensors say: the contract between a robot (simulated or real) and an estimator.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/time.h"

namespace drydock {

/// Angular rate and specific force of the body, in I.
struct ImuSample {
  Eigen::Vector3d angular_rate = Eigen::Vector3d::Zero();  ///< [rad/s], in I.
  Eigen::Vector3d specific_force =
      Eigen::Vector3d::Zero();  ///< [m/s^2], in I; +9.81 along z at rest.
};

/// Both eyes at the same instant.
struct StereoFrame {
  std::int64_t index = 0;  ///< Counts the frames of the rig from 0, dropped ones included.
  std::array<cv::Mat, 2>
      images;  ///< Left and right: 8-bit grey (CV_8UC1) or BGR (CV_8UC3), distorted.
};

/// One ping of the rotating profiling sonar. The beam leaves along (cos, sin, 0)(head_angle) in S.
/// Echoes count if they are stronger than the sheet's intensity_floor.
struct SonarPing {
  double head_angle = 0.0;   ///< [rad] in [0, 2 pi).
  double range = 0.0;        ///< [m] of the strongest echo; 0 where there was none.
  double intensity = 0.0;    ///< Amplitude of that echo, in [0, 1]; 0 where there was none.
  double first_range = 0.0;  ///< [m] of the nearest echo; 0 where there was none.
  /// Amplitude in each of the sheet's bins, the nearest first; 255 is full scale. Often not kept:
  /// then empty.
  std::vector<std::uint8_t> profile;
};

/// Depth below the water's surface by pressure.
struct DepthSample {
  double depth = 0.0;  ///< [m], positive downwards, of the sensor's own position D.
};

using Reading = std::variant<ImuSample, StereoFrame, SonarPing, DepthSample>;

/// A reading with when it was true and when the robot's computer had it.
struct Measurement {
  Time t;          ///< When it was measured.
  Time t_arrival;  ///< >= t.
  Reading reading;
};

}  // namespace drydock
