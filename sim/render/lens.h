// The lens: turns what a pinhole sees into what the distorted camera sees.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/models/camera_model.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

/// Resamples pinhole images to a camera with distortion. The pinhole covers every pixel of the
/// camera.
class Lens {
 public:
  /// InputError if the distortion folds over inside the image.
  explicit Lens(const CameraIntrinsics& intrinsics);

  /// The view that the renderer has to draw for this lens.
  const Pinhole& source() const { return source_; }

  /// Smooth images (light, CV_32FC1 or CV_32FC3) by bicubic interpolation (Catmull-Rom, which keeps
  /// straight ramps straight where OpenCV's bicubic kernel bends them by 0.02 px). `out` has the
  /// camera's size.
  void ApplySmooth(const cv::Mat& pinhole_image, cv::Mat& out) const;
  /// Images with edges that must not be mixed (depth, CV_32FC1): the nearest pixel.
  void ApplyNearest(const cv::Mat& pinhole_image, cv::Mat& out) const;

 private:
  /// Where a camera pixel lies in the pinhole image.
  struct Sample {
    int column = 0;  ///< Whole pixels, rounded down.
    int row = 0;
    std::array<float, 4> across = {};  ///< Weights of columns column - 1 to column + 2.
    std::array<float, 4> down = {};    ///< Weights of rows row - 1 to row + 2.
    bool right_half = false;           ///< The nearest pixel is the next column,
    bool lower_half = false;           ///< or the next row.
  };

  template <int kChannels>
  void Resample(const cv::Mat& pinhole_image, cv::Mat& out) const;

  cv::Size size_;
  Pinhole source_;
  std::vector<Sample> samples_;  ///< Row by row.
};

}  // namespace drydock::sim
