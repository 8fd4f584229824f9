// The lens: turns what a pinhole sees into what the distorted camera sees.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "sensors_models/models/camera_model.h"
#include "sim/render/flat_port.h"
#include "sim/render/port_warp.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

/// Resamples pinhole images to a camera with distortion, and behind a flat port if that is enabled.
/// The pinhole covers every pixel of the camera, which it must do with at most four times its width
/// and height: that is all that is drawn for a lens.
class Lens {
 public:
  /// InputError if the distortion folds over inside the image, or if the view is too wide.
  explicit Lens(const CameraIntrinsics& intrinsics, const FlatPortConfig& port = {});

  /// The view that the renderer has to draw for this lens.
  const Pinhole& source() const { return source_; }

  /// Smooth images (light, CV_32FC1 or CV_32FC3) by bicubic interpolation (Catmull-Rom, which keeps
  /// straight ramps straight where OpenCV's bicubic kernel bends them by 0.02 px). Where the
  /// pinhole has several pixels to one of the camera, which is towards the border of a wide lens,
  /// it is the mean of as many points of the camera's pixel: else fine textures would alias. `out`
  /// has the camera's size. Not for a lens behind a port.
  void ApplySmooth(const cv::Mat& pinhole_image, cv::Mat& out) const;
  /// The same for any lens: a port shifts each pixel by the depth (CV_32FC1, along the axis [m])
  /// that the pinhole sees there.
  void ApplySmooth(const cv::Mat& pinhole_image, const cv::Mat& depth, cv::Mat& out) const;
  /// Depth has edges that must not be mixed: that of the nearest pixel.
  void ApplyNearest(const cv::Mat& depth, cv::Mat& out) const;

 private:
  /// Of four neighbours.
  using Weights = std::array<float, 4>;
  /// Where a point of a camera pixel lies in the pinhole image.
  struct Sample {
    int column = 0;  ///< Whole pixels, rounded down.
    int row = 0;
    Weights across = {};  ///< Of columns column - 1 to column + 2.
    Weights down = {};    ///< Of rows row - 1 to row + 2.
  };
  static constexpr int kPartBits = 10;  ///< Behind a port, weights are for 1024 parts of a pixel.

  template <int kChannels, bool kBehindPort>
  void Resample(const cv::Mat& pinhole_image, const cv::Mat& depth, cv::Mat& out) const;

  Sample SampleAt(const Eigen::Vector2d& ideal) const;

  cv::Size size_;
  Pinhole source_;
  // Row by row.
  std::vector<int> counts_;         ///< How many samples a camera pixel is the mean of.
  std::vector<Sample> samples_;     ///< Those of all pixels.
  std::vector<cv::Point> nearest_;  ///< The pinhole's pixel nearest to a camera pixel.
  // Behind a port, instead of the last two:
  std::optional<PortWarp> warp_;
  std::vector<cv::Point2f> places_;  ///< Of all samples, before the port's shift.
  std::vector<Weights> weights_;     ///< Of each part.
};

}  // namespace drydock::sim
