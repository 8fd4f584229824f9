// Which tracks agree with a rigid scene.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/feature_track.h"
#include "estimator/svin2/frontend/motion_prediction.h"
#include "estimator/svin2/frontend/rig_ransac.h"

namespace drydock::svin2 {

/// Points with a landmark are judged by 3D-2D RANSAC over both cameras, those without by the
/// epipolar line of their pixel in the last frame.
class TrackGate {
 public:
  struct Config {
    RigRansacConfig ransac;
    /// Distance from the line of the last frame's pixel, in pixels of the track's octave.
    double max_epipolar_px = 2.0;
    double min_baseline_m = 0.01;  ///< With less motion between frames there is no line.
  };

  struct Verdict {
    std::vector<bool> left, right;  ///< Of each track: whether that camera's pixel agrees.
    std::optional<Pose> T_WI;       ///< By RANSAC.
  };

  explicit TrackGate(const Config& config) : config_(config) {}

  /// Where there is too little to go by, tracks pass. `seed` drives RANSAC.
  Verdict Judge(const StereoGeometry& geometry, const std::vector<FeatureTrack>& tracks,
                const std::optional<MotionPrediction>& motion, const LandmarkLookup& landmarks,
                std::uint64_t seed) const;

 private:
  Config config_;
};

}  // namespace drydock::svin2
