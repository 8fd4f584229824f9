// A first state, and the account of how it was found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/initialisation/depth_scale.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

struct InitialisedFrame {
  TrackedFrame tracked;
  Pose T_WI;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// What was done and how sure it is.
struct InitialisationReport {
  int frames = 0;
  double seconds = 0.0;
  bool at_rest = false;
  double travelled_m = 0.0;                 ///< From the first frame to the furthest.
  std::optional<ScaleEstimate> from_depth;  ///< Depth alone; nothing without z-excursion.
  ScaleEstimate depth_scale;      ///< s1: the rig's own scale, 1, and depth's by their weights.
  ScaleEstimate alignment_scale;  ///< s2: what the IMU changed after that; sigma of s1 s2.
  double gravity_length = 0.0;    ///< Before it was held on the sphere [m/s^2].
  double tilt_sigma_rad = 0.0;
  double speed_sigma = 0.0;  ///< [m/s]
  double chi2_per_freedom = 0.0;
  ImuBias bias;

  /// On one line.
  std::string Line() const;
};

/// W has z up, and its origin and yaw 0 at the first frame's body.
///
/// Positions and velocities are in metres, scaled by `scale` about the first frame. Where the
/// estimator triangulates landmarks again by a rig whose baseline is off, these come out 1 / scale
/// as large as the path: who believes the scale more than the rig multiplies the baseline by
/// `scale`, else divides path and velocities by it.
struct InitialisedStart {
  std::vector<InitialisedFrame> frames;  ///< Those used, the oldest first, the latest last.
  ImuBias bias;
  double scale = 1.0;  ///< What vision was multiplied by, s1 s2.
  InitialisationReport report;
};

}  // namespace drydock::svin2
