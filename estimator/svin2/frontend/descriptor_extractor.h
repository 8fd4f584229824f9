// Binary descriptors that know which way is down.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "estimator/svin2/frontend/descriptor.h"
#include "sensors_models/models/camera_model.h"

namespace drydock::svin2 {

/// The direction in the image, as an angle from x towards y [rad], into which the camera sees a
/// point at `pixel` move as it falls along `gravity_C` (any length, pointing down, in C). Nothing
/// where the camera looks along gravity there, or the pixel has no ray.
std::optional<double> GravityAngle(const CameraModel& camera, const Eigen::Vector2d& pixel,
                                   const Eigen::Vector3d& gravity_C);

/// Describes points by BRISK's comparisons of smoothed brightness, with the pattern turned to
/// projected gravity: turning the camera about its axis changes nothing, and nothing is lost by
/// estimating a direction from a few grey levels. OpenCV's own BRISK always estimates one.
///
/// The pattern is the paper's: 60 samples on five circles, each sample smoothed in proportion to
/// its spacing, here by a box of the Gaussian's variance. The bits compare the 512 nearest pairs.
class DescriptorExtractor {
 public:
  struct Config {
    double pattern_radius_px = 15.0;  ///< Of the outermost circle of samples.
  };

  /// Throws InputError for values that cannot be used.
  explicit DescriptorExtractor(const Config& config);

  /// One descriptor for each of `pixels` (the camera's) in `image` (CV_8UC1); nothing where the
  /// pattern leaves the image or gravity has no direction. `image` may be a level of a pyramid, of
  /// which a pixel is `scale` pixels of the camera's wide; the pattern is then that much larger.
  std::vector<std::optional<Descriptor>> Describe(const cv::Mat& image,
                                                  const std::vector<Eigen::Vector2d>& pixels,
                                                  const CameraModel& camera,
                                                  const Eigen::Vector3d& gravity_C,
                                                  double scale = 1.0) const;

 private:
  struct Sample {
    Eigen::Vector2d at;  // [px], from the point, for gravity along +x.
    double half_width;   // Of the box [px].
  };
  struct Pair {
    std::uint8_t a, b;
  };

  std::vector<Sample> samples_;
  std::vector<Pair> pairs_;
  double reach_px_ = 0.0;  // No sample's box goes further from the point.
};

}  // namespace drydock::svin2
