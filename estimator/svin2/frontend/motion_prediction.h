// Where the IMU expects known points to be seen.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "estimator/svin2/frontend/feature_track.h"
#include "estimator/svin2/frontend/stereo_geometry.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// By the IMU from the estimator's latest state.
struct MotionPrediction {
  Pose T_WI_before, T_WI_now;  ///< Of the body at the last tracked frame and now.
};

/// The place of a landmark [m, in W], where the estimator has one.
using LandmarkLookup = std::function<std::optional<Eigen::Vector3d>(LandmarkId)>;

/// Carries tracks from the last frame into this one.
class TrackPredictor {
 public:
  struct Point {
    Eigen::Vector2d left = Eigen::Vector2d::Zero();
    std::optional<double> inverse_depth;  ///< [1/m] along the left camera's axis, now.
    bool is_sure = false;                 ///< The motion and the depth were both known.
  };

  /// What is handed over must outlive the predictor.
  TrackPredictor(const StereoGeometry& geometry, const std::optional<MotionPrediction>& motion,
                 const LandmarkLookup& landmarks);

  /// A point moves as its depth has it: the landmark's, else that of stereo, else it is far away.
  /// Without a motion it stays. Landmarks serve for their depth alone: their errors across the line
  /// of sight were there before and are no motion.
  Point Predict(const FeatureTrack& track) const;

 private:
  std::optional<double> InverseDepthBefore(const FeatureTrack& track) const;

  const StereoGeometry& geometry_;
  const LandmarkLookup& landmarks_;
  bool moved_ = false;
  Pose T_C0W_before_;
  Pose T_now_before_;  // Maps points of the left camera then into the left camera now.
};

}  // namespace drydock::svin2
