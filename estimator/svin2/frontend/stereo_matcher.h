// Finds what the left camera has seen in the right camera's image of the same instant.
#pragma once

#include <optional>
#include <vector>

#include "estimator/svin2/frontend/image_pyramid.h"
#include "estimator/svin2/frontend/patch_tracker.h"
#include "estimator/svin2/frontend/stereo_geometry.h"

namespace drydock::svin2 {

/// What the left camera has seen.
struct SoughtInRight {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();
  std::optional<double> inverse_depth;  ///< [1/m], where to start; nothing: search.
  int octave = 0;
};

/// Searches along the epipolar curve where nothing is known of the depth, then tracks the patch
/// from there, and keeps what lies on the curve.
class StereoMatcher {
 public:
  struct Config {
    double min_depth_m = 0.4;  ///< Along the optical axis; nearer things are not found.
    int search_level = 2;      ///< Of the pyramid, or the point's octave if that is higher.
    int search_radius_px = 4;  ///< Of the patch there, in its pixels.
    double min_search_correlation = 0.5;  ///< Of the best place on the curve.
    double max_epipolar_px = 1.5;         ///< Of what is accepted, in pixels of its octave.
  };

  /// Throws InputError for values that cannot be used.
  StereoMatcher(const Config& config, const StereoGeometry& geometry, const PatchTracker& tracker);

  /// The right pixel of each of `points`; pyramids are the tracker's.
  std::vector<PatchTrack> Match(const ImagePyramid& left, const ImagePyramid& right,
                                const std::vector<SoughtInRight>& points) const;

  /// Whether `right` lies where the rig lets the right camera see what the left sees at `left`.
  bool IsOnCurve(const Eigen::Vector2d& left, const Eigen::Vector2d& right, int octave) const;

 private:
  std::optional<Eigen::Vector2d> Search(const ImagePyramid& left, const ImagePyramid& right,
                                        const SoughtInRight& point) const;

  Config config_;
  StereoGeometry geometry_;
  PatchTracker tracker_;
};

}  // namespace drydock::svin2
