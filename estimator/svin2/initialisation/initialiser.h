// Finds the first state: gravity, velocities, biases and scale, from rest or in motion.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/svin2/initialisation/initialised_start.h"
#include "estimator/svin2/initialisation/initialiser_config.h"
#include "estimator/svin2/initialisation/visual_inertial_alignment.h"
#include "estimator/svin2/preintegration/imu_noise_model.h"

namespace drydock::svin2 {

/// What the initialiser is waiting for, or that it is done.
enum class InitialiserStatus {
  kWaiting,             ///< No frame yet.
  kTooFewLandmarks,     ///< Blue water, darkness, a blind eye.
  kNoImu,               ///< No IMU samples between two frames, or too long a gap.
  kNoPose,              ///< Landmarks do not agree on a motion.
  kTurnDisagrees,       ///< Vision and gyro turn differently.
  kCollecting,          ///< All well, too few frames.
  kNoSolution,          ///< The equations have none.
  kGyroDisagrees,       ///< No bias makes the gyro's turns those of vision.
  kGravityImplausible,  ///< Not as strong as gravity is.
  kForceDisagrees,      ///< Accelerations are not those of vision.
  kUncertain,           ///< Tilt or speed is not known well enough.
  kWantsScale,          ///< Scale is not, and the window may grow.
  kStarted,
};

/// Collects stereo frames some tenths of a second apart, finds how the body moved by vision alone
/// (its scale is that of the rig's baseline), and lays that on gyro, depth and accelerometer, in
/// this order. It starts only when all of them agree; until then the window slides. From rest the
/// same equations hold: stereo sees depth, velocities come out as 0, gravity as the mean force.
/// Single-threaded and deterministic.
class Initialiser {
 public:
  using Config = InitialiserConfig;

  /// The depth sensor is used if its rate is above 0.
  Initialiser(const Config& config, const StereoSheet& stereo, const ImuNoiseModel& imu_noise,
              const DepthSheet& depth);

  /// The next frame, with all IMU samples and depth readings since the last one; samples may
  /// overlap those of the last call. Returns the start once it is sure, and is then as new.
  std::optional<InitialisedStart> Add(const TrackedFrame& frame,
                                      std::span<const TimedImuSample> imu,
                                      std::span<const TimedDepth> depth);
  void Restart();

  InitialiserStatus Status() const { return status_; }
  /// The status in words, with numbers, for the event log.
  const std::string& Why() const { return why_; }

 private:
  void Keep(std::span<const TimedImuSample> imu, std::span<const TimedDepth> depth);
  bool IsDue(Time t) const;
  void Forget(Time imu_before, Time depth_before);
  bool Extend(const TrackedFrame& frame);
  void BeginAnew(const TrackedFrame& frame);
  std::optional<InitialisedStart> Attempt();
  bool CorrectGyro(const VisualMotion& motion);
  std::optional<Alignment> AlignInSteps(const VisualMotion& motion, InitialisationReport& report);
  bool Believes(const Alignment& alignment);
  bool WantsMore(const Alignment& alignment, bool at_rest);
  InitialisedStart StartFrom(const Alignment& alignment, const InitialisationReport& report) const;
  void Say(InitialiserStatus status, std::string why);

  Config config_;
  Eigen::Vector3d p_IC_;
  ImuNoiseModel imu_noise_;
  DepthSheet depth_sheet_;
  VisualWindow window_;
  std::vector<ImuPreintegration> deltas_;  ///< Between the window's frames.
  std::vector<TimedImuSample> imu_;        ///< From a little before the window's last frame.
  std::vector<TimedDepth> depth_;          ///< From the window's first frame.
  InitialiserStatus status_ = InitialiserStatus::kWaiting;
  std::string why_ = "waiting for the first frame";
};

}  // namespace drydock::svin2
