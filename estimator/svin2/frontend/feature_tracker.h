// SVIn2's visual front end: from stereo frames to points that are followed.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/anchor_tracker.h"
#include "estimator/svin2/frontend/corner_detector.h"
#include "estimator/svin2/frontend/descriptor_extractor.h"
#include "estimator/svin2/frontend/descriptor_matcher.h"
#include "estimator/svin2/frontend/feature_track.h"
#include "estimator/svin2/frontend/image_pyramid.h"
#include "estimator/svin2/frontend/keyframe_memory.h"
#include "estimator/svin2/frontend/keyframe_rule.h"
#include "estimator/svin2/frontend/keypoint_sigma.h"
#include "estimator/svin2/frontend/motion_prediction.h"
#include "estimator/svin2/frontend/patch_tracker.h"
#include "estimator/svin2/frontend/preprocessor.h"
#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/frontend/stereo_matcher.h"
#include "estimator/svin2/frontend/track_gate.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/frontend/unfollowed_corners.h"
#include "sensors_models/measurement/measurement.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

/// How points are found again in the next frame.
enum class Matching {
  kPatches,      ///< Lucas-Kanade from frame to frame, then alignment with the anchor patch.
  kDescriptors,  ///< Corners of each frame by their descriptors, then the same alignment.
  kBoth,         ///< Patches; at keyframes descriptors regain what was lost.
};

/// Follows corners through stereo frames. Deterministic.
class FeatureTracker {
 public:
  struct Config {
    Matching matching = Matching::kBoth;
    /// Levels of the pyramid in which corners are looked for, the image's own first. What haze and
    /// noise leave of the fine ones shows in stereo: where the right image does not have a corner,
    /// coarser ones may be. Only while patches are followed, and no more than Lucas-Kanade has.
    int octaves = 3;
    /// The n-th coarser level is looked at where both eyes see fewer points than this / n.
    int enough_points = 60;
    bool preprocess = true;
    Preprocessor::Config preprocessor;
    CornerDetector::Config detector;
    /// Of all levels but the image's own, in their pixels. Stereo sorts out what is noise.
    CornerDetector::Config coarse_detector = {.radius_px = 10.0, .min_score = 1e-4};
    DescriptorExtractor::Config descriptor;
    DescriptorMatcher::Config descriptor_matcher;
    /// Of Lucas-Kanade, and of the first match in stereo, which the rig's geometry checks.
    PatchTracker::Config patches = {.min_correlation = 0.7};
    AnchorTracker::Config anchors;
    StereoMatcher::Config stereo;
    TrackGate::Config gate;
    KeyframeRule::Config keyframes;
    int memory_keyframes = 3;  ///< The newest, whose lost points are looked for.
    /// Frames this long after the last that was described are described too, for loop closing;
    /// nothing: keyframes alone. Tracks stay as they are.
    std::optional<Duration> describe_every = std::nullopt;
    /// Of described frames, for loop closing: only with `describe_every`.
    UnfollowedCorners::Config unfollowed;
    KeypointSigma sigma;
  };

  /// Throws InputError for values that cannot be used.
  FeatureTracker(const Config& config, const StereoSheet& sheet);

  /// The next frame. `prediction` by the IMU, where there is one, and the `landmarks` that the
  /// estimator has make tracks longer and outliers fewer. Images of a wrong size or type give an
  /// empty frame, and tracks wait for the next; blank ones end all tracks.
  TrackedFrame Track(Time t, const StereoFrame& images,
                     const std::optional<MotionPrediction>& prediction,
                     const LandmarkLookup& landmarks);

 private:
  struct Pyramids {
    ImagePyramid left, right;
  };
  // What is known about the frame at hand.
  struct Context {
    const Pyramids& now;
    const std::optional<MotionPrediction>& motion;
    const LandmarkLookup& landmarks;
    Eigen::Vector3d gravity_C;  // Down, in the left camera.
  };

  bool IsUsable(const StereoFrame& images) const;
  Pyramids MakePyramids(const StereoFrame& images);
  std::vector<FeatureTrack> Follow(const Context& context, const TrackPredictor& predictor) const;
  std::vector<FeatureTrack> FollowPatches(const Context& context,
                                          const std::vector<TrackPredictor::Point>& points) const;
  std::vector<FeatureTrack> FollowDescriptors(
      const Context& context, const std::vector<TrackPredictor::Point>& points) const;
  void MatchStereo(const Pyramids& now, bool search, std::vector<FeatureTrack>& tracks) const;
  bool AcceptRight(const Eigen::Vector2d& right, FeatureTrack& track) const;
  bool FollowInRight(const ImagePyramid& right, FeatureTrack& track) const;
  std::optional<Pose> RemoveOutliers(const Context& context, Time t,
                                     std::vector<FeatureTrack>& tracks) const;
  void AddCorners(const Context& context, const std::optional<Pose>& T_WI);
  void Describe(const Context& context, std::vector<FeatureTrack>& tracks) const;
  std::vector<FeatureTrack> Regain(int octave, const Context& context, const Pose& T_WI,
                                   std::vector<FeatureTrack>& corners) const;
  std::vector<FeatureTrack> NewTracks(int octave, const ImagePyramid& image) const;
  TrackedFrame Report(Time t) const;
  bool IsToBeDescribed(Time t) const;
  void ReportDescriptors(const Context& context, const std::vector<FeatureTrack>& tracks,
                         TrackedFrame& frame);

  Config config_;
  StereoGeometry geometry_;
  Preprocessor preprocessor_;
  CornerDetector detector_, coarse_detector_;
  DescriptorExtractor extractor_;
  DescriptorMatcher matcher_;
  PatchTracker flow_;  // Lucas-Kanade alone.
  AnchorTracker anchors_;
  StereoMatcher stereo_;
  UnfollowedCorners unfollowed_;
  TrackGate gate_;
  KeyframeRule keyframes_;
  KeyframeMemory memory_;

  LandmarkId next_id_ = 1;
  std::vector<FeatureTrack> tracks_;  // Sorted by id.
  std::optional<Pyramids> before_;
  std::optional<Time> last_described_;
  // Where images cannot be used: the body at the last ones that could, for tracks wait there.
  std::optional<Pose> T_WI_used_;
};

}  // namespace drydock::svin2
