// When the estimator may start, and what it believes before.
#pragma once

#include "estimator/svin2/initialisation/depth_scale.h"
#include "estimator/svin2/initialisation/visual_window.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::svin2 {

struct InitialiserConfig {
  int min_landmarks = 15;  ///< In each frame, by stereo; the paper's number.
  /// Between the frames used: three at 15 Hz. Those in between only have to have enough points.
  double frame_spacing_s = 0.19;
  double max_gap_s = 0.5;  ///< Between frames; after a longer one it begins anew.
  int min_frames = 6;      ///< Spaced so: a second.
  int max_frames = 16;     ///< Three seconds; the oldest goes.
  /// What is believed of the rig's own scale: how far its baseline may be wrong, as a share.
  double stereo_scale_sigma = 0.02;
  /// Waits for a scale this sure while it moves, as long as the window grows.
  double wanted_scale_sigma = 0.025;
  double gyro_bias_sigma = 0.01;   ///< At turn-on [rad/s]; only where the IMU's sheet has none.
  double accel_bias_sigma = 0.05;  ///< At turn-on [m/s^2]; likewise.
  /// Largest squared error, weighed by what was expected of it, per degree of freedom.
  double max_chi2 = 3.0;
  double max_gravity_error = 0.4;    ///< Of its length, where it is free [m/s^2].
  double max_tilt_sigma_rad = 0.02;  ///< Of gravity's direction.
  double max_speed_sigma = 0.1;      ///< Of the last velocity [m/s].
  double moving_m = 0.05;            ///< Vision that goes no further than this is at rest.
  DepthScaleConfig depth;
  VisualWindowConfig vision;
};

/// Reads what `reader` has of the above, by the same names with their units (as
/// gyro_bias_sigma_rad_s); depth and vision have their defaults.
InitialiserConfig ReadInitialiserConfig(YamlReader& reader);

}  // namespace drydock::svin2
