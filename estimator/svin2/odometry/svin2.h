// Sonar-visual-inertial-depth odometry (SVIn2).
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/frontend/feature_tracker.h"
#include "estimator/svin2/frontend/motion_prediction.h"
#include "estimator/svin2/odometry/imu_buffer.h"
#include "estimator/svin2/window/sliding_window.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

/// Follows points through stereo frames: the visual front end.
using Tracker = std::function<TrackedFrame(
    Time, const StereoFrame&, const std::optional<MotionPrediction>&, const LandmarkLookup&)>;

struct Svin2Config {
  bool use_sonar = true;
  bool use_depth = true;
  /// What the estimator believes of the IMU's noise, as a multiple of its sheet.
  double imu_noise_inflation = 2.0;
  FeatureTracker::Config frontend;
  WindowConfig window;
  StartSigmas start;
};

class Svin2 final : public Estimator {
 public:
  Svin2(const Rig& rig, const Svin2Config& config, Tracker tracker);

  void Start(const std::optional<NavState>& known) override;
  void Add(const Measurement& measurement) override;
  void Finish() override;
  std::optional<NavEstimate> Latest() const override;
  const Trajectory& Odometry() const override { return odometry_; }
  std::vector<Eigen::Vector3d> Map() const override { return window_.LandmarkPositions(); }
  EstimatorTimings Timings() const override { return clock_.Summary(); }

 private:
  struct PendingFrame {
    Time t, t_arrival;
    StereoFrame frame;
  };
  struct PendingDepth {
    Time t;
    double depth = 0.0;
  };

  void ProcessPending(Time now);
  void Process(const PendingFrame& pending);
  void StartFrom(const NavState& known, const PendingFrame& pending);
  TrackedFrame Track(const PendingFrame& pending,
                     const std::optional<MotionPrediction>& prediction);
  void AddPendingDepths(Time until);
  ImuBias Bias() const;
  void Publish();

  Rig rig_;
  Svin2Config config_;
  Tracker tracker_;
  ImuBuffer imu_;
  SlidingWindow window_;
  std::deque<PendingFrame> frames_;
  std::deque<PendingDepth> depths_;
  std::optional<DepthReference> depth_reference_;
  std::optional<NavState> known_;
  std::optional<NavEstimate> latest_;
  Trajectory odometry_;
  StageClock clock_;
};

/// The rig's sheet with its noise inflated.
ImuNoiseModel NoiseModelOf(const ImuSheet& sheet, double inflation);

}  // namespace drydock::svin2
