// A lamp as one camera has it.
#pragma once

#include <Eigen/Core>

#include "sensors_models/base/pose.h"
#include "sim/optics/lamp_config.h"

namespace drydock::sim {

struct LampInCamera {
  Eigen::Vector3d position_C = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d axis_C = Eigen::Vector3d::UnitZ();     ///< Unit vector.
  double sharpness = 1.0;                                ///< k of LampConfig.
  /// Illuminance at 1 m of clear water per channel, as a share of full sun.
  Eigen::Array3d intensity = Eigen::Array3d::Zero();

  /// A lamp is no point: within this distance it grows no brighter [m].
  static constexpr double kNearest = 0.05;

  /// Illuminance of a surface at `p_C` [m, in C] that squarely faces the lamp, through water of
  /// this beam attenuation [1/m], per channel, as a share of full sun. Nothing throws shadows.
  Eigen::Array3d IlluminanceAt(const Eigen::Vector3d& p_C, const Eigen::Array3d& attenuation) const;
};

/// `T_IC` is the camera's pose on the body.
LampInCamera SeenFrom(const LampConfig& lamp, const Pose& T_IC);

}  // namespace drydock::sim
