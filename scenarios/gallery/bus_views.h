// What a diver's left eye sees of the bus.
#pragma once

#include <span>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "scenarios/runner/scenario.h"
#include "scenes/scene.h"
#include "sensors_models/measurement/rig.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/stereo_camera.h"

namespace drydock {

/// The bus dive, to look around in.
class BusViews {
 public:
  BusViews();

  /// The dive's own water.
  const sim::WaterConfig& water() const { return scenario_.water; }
  /// The left image (CV_8UC3 if `color`, else CV_8UC1) at each of the `moments` of the dive [s].
  std::vector<cv::Mat> LeftImages(const sim::WaterConfig& water, bool color,
                                  std::span<const double> moments);

 private:
  Scenario scenario_;
  Rig rig_;
  sim::SplineMotion motion_;
  sim::World world_;
  sim::RayScene rays_;
};

}  // namespace drydock
