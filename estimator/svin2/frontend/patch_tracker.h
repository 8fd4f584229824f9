// Follows small patches from image to image.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "estimator/svin2/frontend/image_pyramid.h"

namespace drydock::svin2 {

enum class TrackStatus {
  kTracked,
  kOutside,          ///< The start, its prediction or what was found lies outside the image.
  kNotFound,         ///< Too little texture, or no convergence.
  kForwardBackward,  ///< Tracked back, it does not return to where it came from.
  kUnlike,           ///< What was found does not look like what was sought.
  kOffEpipolar,      ///< It does not lie where the calibrated rig allows it to.
};

struct PatchTrack {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< In the new image, if tracked.
  double correlation = 0.0;  ///< Of both patches' grey values, -1 to 1, once aligned.
  TrackStatus status = TrackStatus::kNotFound;

  bool IsTracked() const { return status == TrackStatus::kTracked; }
};

/// Pyramidal Lucas-Kanade, forth and back, and then an alignment of the patch that also estimates
/// its affine deformation and its change of brightness and contrast (inverse compositional, Baker
/// and Matthews 2004).
class PatchTracker {
 public:
  struct Config {
    int window_px = 21;  ///< Of Lucas-Kanade, odd.
    int levels = 4;      ///< Of the pyramid, each half as large as the one before.
    double max_forward_backward_px = 0.5;  ///< 0: not tracked back.
    int patch_radius_px = 12;  ///< Of the final alignment, 2 r + 1 squared; 0: none of it.
    /// The patch may turn, stretch and shear; else only shift. From frame to frame there is little
    /// of that, and the four numbers cost accuracy: for patches that were first seen long ago.
    bool affine = false;
    double min_correlation = 0.8;
    double max_align_px = 1.5;  ///< An alignment that moves further has gone astray.
  };

  /// Throws InputError for values that cannot be used.
  explicit PatchTracker(const Config& config);

  /// `image` is CV_8UC1. Made once, and used with its predecessor and its successor.
  ImagePyramid MakePyramid(const cv::Mat& image) const {
    return MakePyramid(image, config_.levels);
  }
  /// The same of the finest `levels` only, for a caller who has others in mind for the rest.
  ImagePyramid MakePyramid(const cv::Mat& image, int levels) const;

  /// Where the patches about `pixels` in `from` are in `to`. The search starts at `predicted` (one
  /// each). A patch, and what the configuration says of it, is in pixels of its octave (`octaves`,
  /// one each; empty: all 0), all else in the image's.
  std::vector<PatchTrack> Track(const ImagePyramid& from, const ImagePyramid& to,
                                const std::vector<Eigen::Vector2d>& pixels,
                                const std::vector<Eigen::Vector2d>& predicted,
                                const std::vector<int>& octaves = {}) const;

 private:
  std::vector<PatchTrack> TrackInOctave(const ImagePyramid& from, const ImagePyramid& to,
                                        const std::vector<Eigen::Vector2d>& pixels,
                                        const std::vector<Eigen::Vector2d>& predicted) const;

  Config config_;
};

}  // namespace drydock::svin2
