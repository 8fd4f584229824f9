// What haze leaves of a place, to know it again by.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/svin2/frontend/corner_detector.h"
#include "estimator/svin2/frontend/descriptor_extractor.h"
#include "estimator/svin2/frontend/feature_track.h"
#include "estimator/svin2/frontend/keypoint_sigma.h"
#include "estimator/svin2/frontend/patch_tracker.h"
#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/stereo_matcher.h"
#include "estimator/svin2/frontend/tracked_frame.h"

namespace drydock::svin2 {

/// Coarse corners that both eyes see and nobody follows, with descriptors. Few fine corners are
/// found again when a place is seen anew through haze; so coarse ones are.
class UnfollowedCorners {
 public:
  struct Config {
    CornerDetector::Config detector = {.radius_px = 6.0, .min_score = 1e-4};  ///< In its octave.
    int octave = 2;
    int enough_points = 100;  ///< They are looked for where both eyes see fewer that are followed.
    /// Of the eyes' patches: less than of what is followed, for loop closing sorts out the rest.
    double min_correlation = 0.5;
  };

  /// Throws InputError for values that cannot be used.
  UnfollowedCorners(const Config& config, const StereoGeometry& geometry,
                    const StereoMatcher::Config& stereo, PatchTracker::Config patches);

  /// Away from `tracks` of the same octave; `gravity_C` is down in the left camera. Their ids rise
  /// from call to call, and lie above those of all landmarks.
  std::vector<TrackedPoint> Find(const ImagePyramid& left, const ImagePyramid& right,
                                 const std::vector<FeatureTrack>& tracks,
                                 const Eigen::Vector3d& gravity_C,
                                 const DescriptorExtractor& extractor, const KeypointSigma& sigma);

 private:
  Config config_;
  CameraModel camera_;  // The left one.
  CornerDetector detector_;
  StereoMatcher stereo_;
  LandmarkId next_id_ = LandmarkId{1} << 63U;
};

}  // namespace drydock::svin2
