// The last tenth of a pixel of a patch track.
#pragma once

#include <Eigen/Core>
#include <optional>

#include <opencv2/core/mat.hpp>

namespace drydock::svin2 {

struct PatchAlignment {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double correlation = 0.0;  ///< Of the grey values, -1 to 1.
};

/// Finds the patch of `from` (CV_8UC1) about `pixel`, (2 radius + 1)^2 large, in `to` near `start`.
/// The patch may shift, deform affinely if `affine`, and change in brightness and contrast. Nothing
/// if a patch leaves its image, has too little texture, or the search moves on and on.
std::optional<PatchAlignment> AlignPatch(const cv::Mat& from, const Eigen::Vector2d& pixel,
                                         const cv::Mat& to, const Eigen::Vector2d& start,
                                         int radius, bool affine);

}  // namespace drydock::svin2
