// Blur: light that water bends by a fraction of a degree still arrives, beside where it belongs.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sim/optics/water_config.h"

namespace drydock::sim {

/// Small-angle scattering as a compound Poisson process. Along a range r light is bent tau = share
/// * b * r times on average, b being the scattering coefficient (green); exp(-tau) of it is not
/// bent at all and stays sharp. A bend by an angle of variance theta^2 at a random place of the way
/// shifts the image point by one of variance theta^2 / 3, so the bent light has, in pixels, the
/// variance
///   (focal theta)^2 / 3 * tau / (1 - exp(-tau)),
/// and that of all light grows in proportion to the range. Bent light comes from two layers of an
/// image pyramid, mixed so that their variance is right at each pixel's own range.
///
/// An approximation at silhouettes: a pixel spreads by its own range, not by that of its
/// neighbours.
class ForwardScatter {
 public:
  ForwardScatter(const WaterConfig& water, double focal);

  /// Adds `direct` (light from surfaces, CV_32FC1, at `range` [m, CV_32FC1]) to `radiance`, blurred
  /// as above.
  void AddTo(const cv::Mat& direct, const cv::Mat& range, cv::Mat& radiance);

 private:
  /// Variance that layer `level` and its interpolation bring [px^2].
  static double LayerVariance(int level);
  void Upsample(std::size_t layer, int row, int width);

  float scattering_;  ///< tau a metre; 0 for no blur.
  float variance_;    ///< Of one bend [px^2].
  int level_ = 0;     ///< Of the sharper layer; the other is the next.
  std::vector<cv::Mat> pyramid_;
  std::array<std::vector<float>, 2> coarse_;  ///< Of both layers: a row between two of its own,
  std::array<std::vector<float>, 2> fine_;    ///< and the same at full width.
};

}  // namespace drydock::sim
