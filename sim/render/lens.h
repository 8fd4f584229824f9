// The lens: turns what a pinhole sees into what the distorted camera sees.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "sensors_models/models/camera_model.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

/// Resamples pinhole images to a camera with distortion. The pinhole covers every pixel of the
/// camera, which it must do with at most four times its width and height: that is all that is
/// drawn for a lens.
class Lens {
 public:
  /// InputError if the distortion folds over inside the image, or if the view is too wide.
  explicit Lens(const CameraIntrinsics& intrinsics);

  /// The view that the renderer has to draw for this lens.
  const Pinhole& source() const { return source_; }

  /// Smooth images (light, CV_32FC1 or CV_32FC3) by bicubic interpolation (Catmull-Rom, which keeps
  /// straight ramps straight where OpenCV's bicubic kernel bends them by 0.02 px). Where the
  /// pinhole has several pixels to one of the camera, which is towards the border of a wide lens,
  /// it is the mean of as many points of the camera's pixel: else fine textures would alias. `out`
  /// has the camera's size.
  void ApplySmooth(const cv::Mat& pinhole_image, cv::Mat& out) const;
  /// Images with edges that must not be mixed (depth, CV_32FC1): the nearest pixel.
  void ApplyNearest(const cv::Mat& pinhole_image, cv::Mat& out) const;

 private:
  /// Where a point of a camera pixel lies in the pinhole image.
  struct Sample {
    int column = 0;  ///< Whole pixels, rounded down.
    int row = 0;
    std::array<float, 4> across = {};  ///< Weights of columns column - 1 to column + 2.
    std::array<float, 4> down = {};    ///< Weights of rows row - 1 to row + 2.
  };

  template <int kChannels>
  void Resample(const cv::Mat& pinhole_image, cv::Mat& out) const;

  Sample SampleAt(const Eigen::Vector2d& ideal) const;

  cv::Size size_;
  Pinhole source_;
  // Row by row.
  std::vector<int> counts_;         ///< How many samples a camera pixel is the mean of.
  std::vector<Sample> samples_;     ///< Those of all pixels.
  std::vector<cv::Point> nearest_;  ///< The pinhole's pixel nearest to a camera pixel.
};

}  // namespace drydock::sim
