// How much of the veil is left where water lies in shadow: the dark inside of a wreck, shafts of
// light.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/optics/daylight_grid.h"
#include "sim/optics/water_config.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

/// The share of the veil's light that reaches the water between camera and surface. Some rays, on a
/// raster of pixels, are followed through the water, through whatever stands there, at places that
/// each stand for the same part of the unshadowed veil. A pixel takes what lies up to its own
/// range, interpolated between the rays around it.
class VeilLight {
 public:
  VeilLight(const WaterConfig& water, const Pinhole& pinhole);

  /// Follows the rays of a view.
  void Look(const Pose& T_WC, DaylightGrid& shadows);

  /// The shares of row `v`, one for each pixel, whose ranges [m] are given.
  const float* Row(int v, const float* range);

 private:
  static constexpr int kRaster = 16;  ///< [px]
  static constexpr int kSlices = 6;   ///< Of each ray.

  void LookAlongRow(int row, const Pose& T_WC, DaylightGrid& shadows);

  Pinhole pinhole_;
  double attenuation_;  ///< c in green [1/m].
  float sun_share_;
  /// How much of each slice is lit: CV_32FC1, one for each ray, a row and a column more than there
  /// are cells.
  std::array<cv::Mat, kSlices> lit_;
  std::vector<float> coarse_;                       ///< A row between two rows of rays,
  std::array<std::vector<float>, kSlices> slices_;  ///< and the same at full width.
  std::vector<float> seen_;
  std::vector<float> shares_;
};

}  // namespace drydock::sim
