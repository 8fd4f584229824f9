// Finds what the left camera has seen in the right camera's image of the same instant.
#pragma once

#include <optional>
#include <vector>

#include "estimator/svin2/frontend/patch_tracker.h"
#include "estimator/svin2/frontend/stereo_geometry.h"

namespace drydock::svin2 {

/// Searches along the epipolar curve where nothing is known of the depth, then tracks the patch
/// from there, and keeps what lies on the curve.
class StereoMatcher {
 public:
  struct Config {
    double min_depth_m = 0.4;             ///< Along the optical axis; nearer things are not found.
    int search_level = 2;                 ///< Of the pyramid at which the curve is searched.
    int search_radius_px = 4;             ///< Of the patch there, in its pixels.
    double min_search_correlation = 0.5;  ///< Of the best place on the curve.
    double max_epipolar_px = 1.5;         ///< Of what is accepted.
  };

  /// Throws InputError for values that cannot be used.
  StereoMatcher(const Config& config, const StereoGeometry& geometry, const PatchTracker& tracker);

  /// The right pixels of `pixels` in the left image; pyramids are the tracker's.
  /// `inverse_depths` [1/m], one for each pixel, are where to start; nothing: search.
  std::vector<PatchTrack> Match(const PatchTracker::Pyramid& left,
                                const PatchTracker::Pyramid& right,
                                const std::vector<Eigen::Vector2d>& pixels,
                                const std::vector<std::optional<double>>& inverse_depths) const;

  /// Whether `right` lies where the rig lets the right camera see what the left sees at `left`.
  bool IsOnCurve(const Eigen::Vector2d& left, const Eigen::Vector2d& right) const;

 private:
  std::optional<Eigen::Vector2d> Search(const cv::Mat& left, const cv::Mat& right, double scale,
                                        const Eigen::Vector2d& pixel) const;

  Config config_;
  StereoGeometry geometry_;
  PatchTracker tracker_;
};

}  // namespace drydock::svin2
