// Tracks, IMU samples and depth readings of a rig that swims among scattered landmarks.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/frontend/tracked_frame.h"
#include "estimator/svin2/initialisation/depth_scale.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"
#include "estimator/svin2/preintegration/imu_segments.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2::testing {

/// Everything goes by sines, so that the IMU's readings have a closed form.
struct SyntheticMotion {
  struct Sine {
    double amplitude = 0.0, rate = 0.0, phase = 0.0;  ///< Of a sin(rate t + phase).
  };
  Eigen::Vector3d speed_W = Eigen::Vector3d::Zero();  ///< [m/s], constant part.
  std::array<Sine, 3> sway;                           ///< Of the position [m], in W.
  Sine yaw, pitch;                                    ///< [rad]
  double roll = 0.0;                                  ///< [rad]

  NavState At(double s) const;
  ImuSample Imu(double s) const;
};

enum class MotionKind { kStill, kMoving, kPitching };

/// A motion of this kind, random by seed: standing still; swimming at 0.1 to 0.4 m/s with sway; or
/// that with a pitch of up to 20 degrees and back within seconds, and diving.
SyntheticMotion RandomMotion(MotionKind kind, std::uint64_t seed);

/// The v3 rig's sheets, cameras straight ahead.
StereoSheet V3Stereo();
DepthSheet V3Depth();
/// The same with the right camera further away from the left one.
StereoSheet WithBaseline(StereoSheet sheet, double factor);

struct SyntheticDiveConfig {
  SyntheticMotion motion;
  std::uint64_t seed = 1;
  double begin_s = 0.0;  ///< Along the motion.
  double length_s = 5.0;
  double pixel_sigma = 0.0;    ///< [px]
  double outlier_share = 0.0;  ///< Of pixels that lie up to 40 px beside, each time anew.
  int max_points = 150;        ///< In a frame.
  bool imu_noise = false;      ///< White noise and random constant biases of the v3 rig.
  bool depth_noise = false;    ///< White noise and steps of the v3 rig.
  ImuBias bias;                ///< Added to the random one.
};

/// What one call of Initialiser::Add() takes.
struct SyntheticInput {
  TrackedFrame frame;
  std::vector<TimedImuSample> imu;
  std::vector<TimedDepth> depth;
};

struct SyntheticDive {
  std::vector<SyntheticInput> inputs;
  ImuBias bias;  ///< That the samples have.
};

/// Frames at 15 Hz, IMU at 100 Hz, depth at 1 Hz, 5 m below the surface.
SyntheticDive MakeSyntheticDive(const SyntheticDiveConfig& config);

}  // namespace drydock::svin2::testing
