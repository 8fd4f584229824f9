// Noise over a whole image: the raw material of every texture.
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace drydock::scenes {

/// Gradient noise summed over octaves of halving size.
struct NoiseShape {
  double largest = 64.0;   ///< size of the first octave's cells [pixels]
  double smallest = 3.0;   ///< octaves go on while their cells are at least this large [pixels]
  double gain = 0.6;       ///< amplitude of an octave relative to the one before
  double stretch_y = 1.0;  ///< > 1: features longer down the image than across
  bool wrap = false;       ///< the left meets the right and the top the bottom
};

/// About normally distributed with mean 0 and standard deviation 1, whatever the shape: thresholds
/// mean coverage. A function of shape, size and key alone, the same at any number of threads.
cv::Mat1f NoiseField(cv::Size size, const NoiseShape& shape, std::uint64_t key);

/// 255 on about `fraction` of the image, where the field is highest; edges as soft as `softness`
/// standard deviations (0.05 looks cut, 1 looks misty).
cv::Mat1b Coverage(const cv::Mat1f& field, double fraction, double softness);

/// As Coverage, between the thresholds themselves: 0 below `low`, 255 above `high`.
cv::Mat1b Ramp(const cv::Mat1f& field, double low, double high);

/// 255 on the field's zero lines, which are this wide in standard deviations: cracks, veins, the
/// grooves of bark.
cv::Mat1b ZeroLines(const cv::Mat1f& field, double width);

/// field += weight * mask / 255: for drawing what grows towards edges and seams.
void AddMask(cv::Mat1f& field, const cv::Mat1b& mask, double weight);

}  // namespace drydock::scenes
