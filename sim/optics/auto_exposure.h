// The camera's exposure control.
#pragma once

#include <array>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/time.h"
#include "sim/optics/image_sensor.h"

namespace drydock::sim {

/// Mean radiance of an image (CV_32FC1 or CV_32FC3) on a coarse raster of its pixels.
double MeterLight(const cv::Mat& radiance);

/// Aims at a mean share of the full well, from frame to frame, both eyes alike. The logarithm of
/// the exposure follows that aim with a first-order lag in seconds, whatever the frame rate: over
/// dt it covers 1 - exp(-dt / time constant) of the way that the frame before asked for.
class AutoExposure {
 public:
  /// With `fixed` (radiance times this saturates) it does not move.
  AutoExposure(const ImagerSheet& imager, std::optional<double> fixed);

  /// The exposure of the frame at `t`, from the frames before it; of the very first from `light`
  /// itself, as the camera ran before the dive. `light` is this frame's mean radiance. Times must
  /// grow.
  Exposure Next(Time t, double light);
  /// The exposure in a steady view of mean radiance `light`.
  Exposure Settled(double light) const;

 private:
  double Aim(double light) const;

  ImagerSheet imager_;
  std::optional<double> fixed_;
  double log_scale_ = 0.0;
  double last_light_ = 0.0;
  std::optional<Time> last_time_;
};

}  // namespace drydock::sim
