// Sonar-visual-inertial-depth odometry (SVIn2).
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimator/interface/estimator.h"
#include "estimator/svin2/initialisation/initialiser.h"
#include "estimator/svin2/odometry/depth_link.h"
#include "estimator/svin2/odometry/describe_keyframe.h"
#include "estimator/svin2/odometry/imu_buffer.h"
#include "estimator/svin2/odometry/sonar_link.h"
#include "estimator/svin2/odometry/svin2_config.h"
#include "estimator/svin2/odometry/timed_point.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::svin2 {

/// Follows points through stereo frames: the visual front end.
using Tracker = std::function<TrackedFrame(
    Time, const StereoFrame&, const std::optional<MotionPrediction>&, const LandmarkLookup&)>;

/// The estimator of the paper, without loop closing. Publishes a pose at each stereo frame, once
/// the IMU has come up to it, and twice a second while no frames come. Readings that are not
/// finite, and stamps that are not later than the one before of the same sensor, are refused and
/// counted.
class Svin2 final : public Estimator {
 public:
  Svin2(const Rig& rig, const Svin2Config& config, Tracker tracker);

  /// Without `known` it initialises itself; W's origin and yaw are then those of the body there.
  void Start(const std::optional<NavState>& known) override;
  void Add(const Measurement& measurement) override;
  void Finish() override;

  std::optional<NavEstimate> Latest() const override { return latest_; }
  const Trajectory& Odometry() const override { return odometry_; }
  /// Standard deviation of each one's position [m]: what is not known is that of the one before.
  const std::vector<double>& PositionSigmas() const { return position_sigmas_; }
  /// The landmarks that have left the window, and the echoes.
  EstimatedMap Map() const override;
  std::vector<EstimatorEvent> TakeEvents() override;
  EstimatorTimings Timings() const override { return clock_.Summary(); }

  /// The keyframes since the last call, if Svin2Config::report_keyframes.
  std::vector<Keyframe> TakeKeyframes() { return std::exchange(keyframes_, {}); }
  /// Landmarks that have left the window, where they were last.
  const std::vector<TimedPoint>& Landmarks() const { return landmarks_; }
  /// Where the sonar met something.
  const std::vector<TimedPoint>& Echoes() const { return sonar_.echoes(); }

 private:
  struct PendingFrame {
    Time t, t_arrival;
    std::optional<StereoFrame> images;  ///< Nothing: the cameras were silent.
  };

  void AddStereo(const Measurement& measurement, const StereoFrame& images);
  void Refuse(Time t, int& count, const char* what);
  void ProcessPending(Time now);
  void SitOutSilence(Time now);
  void Process(const PendingFrame& pending);

  TrackedFrame Track(const PendingFrame& pending,
                     const std::optional<MotionPrediction>& prediction);
  void Advance(const PendingFrame& pending);
  void Initialise(const TrackedFrame& seen);
  void BeginFrom(const NavState& known, const PendingFrame& pending);
  void BeginFrom(const InitialisedStart& start);
  Pose Placement(Time t, const Eigen::Quaterniond& q) const;
  void AddFrame(const TrackedFrame& seen, const ImuPreintegration& imu);
  void ExpectHabit(Duration since_last);
  void UsePings(const NavState& before);
  void NoteKeyframe(const TrackedFrame& seen);
  void UseDepths();
  void Publish(const TrackedFrame& seen);
  void SayStatus(TrackingStatus before, const NavEstimate& now);
  void Say(Time t, std::string message);

  Rig rig_;
  Svin2Config config_;
  StartSigmas start_sigmas_;
  Tracker tracker_;
  ImuBuffer imu_;
  Initialiser initialiser_;
  std::unique_ptr<SlidingWindow> window_;  // Nothing before the first state.
  DepthLink depths_;
  SonarLink sonar_;
  TrackingMonitor monitor_;
  SwimmingHabit habit_;

  std::deque<PendingFrame> frames_;
  std::optional<Time> last_frame_;    // Taken in.
  std::optional<Time> last_tracked_;  // Processed.
  std::vector<Keyframe> keyframes_;
  int last_keyframe_ = -1;
  std::optional<Time> last_reported_;  // Of keyframes and glimpses.
  std::vector<TimedPoint> landmarks_;
  std::optional<NavState> known_;

  std::optional<NavEstimate> latest_;
  Trajectory odometry_;
  std::vector<double> position_sigmas_;
  int map_id_ = 0;
  int refused_imu_ = 0, refused_frames_ = 0, refused_depths_ = 0, refused_pings_ = 0;
  std::vector<EstimatorEvent> events_;
  StageClock clock_;
};

/// SVIn2 with its own front end.
std::unique_ptr<Svin2> MakeSvin2(const Rig& rig, const Svin2Config& config);

}  // namespace drydock::svin2
