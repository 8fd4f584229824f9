// The one door to every estimator.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "estimator/interface/stage_timings.h"
#include "sensors_models/base/trajectory.h"
#include "sensors_models/measurement/measurement.h"

namespace drydock {

/// State of the body in the world frame of the estimator (z up).
struct NavState {
  Time t;
  Pose T_WI;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();         ///< [m/s], in W.
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();   ///< [rad/s], in I.
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();  ///< [m/s^2], in I.
};

enum class TrackingStatus {
  kInitialising,   ///< No state yet.
  kTracking,       ///< All sensors that the estimator wants are in use.
  kDeadReckoning,  ///< Carries on by inertial and depth alone.
  kLost,
};

/// How well the cameras serve, in the latest frame.
struct VisionHealth {
  int landmarks_in_view = 0;  ///< Points whose place is being estimated.
  int tracked_points = 0;     ///< Followed from the frame before.
  int empty_quadrants = 4;    ///< Of the left image's four.
};

struct NavEstimate {
  NavState state;
  /// Of [p, alpha], left perturbation [m, rad], in W; where the estimator has one.
  std::optional<Eigen::Matrix<double, 6, 6>> pose_covariance;
  TrackingStatus status = TrackingStatus::kInitialising;
  std::optional<VisionHealth> vision;  ///< Where the estimator has eyes.
  /// Counts up when the estimator starts afresh, with no known relation to the world frame before.
  int map_id = 0;
  /// Takes the world frame to where it would be without drift, by the loops closed so far; the
  /// state itself stays smooth.
  Pose T_GW;
};

/// A place that the estimator recognised.
struct LoopClosure {
  Time t_now;
  Time t_then;
  Pose T_then_now;  ///< Maps points of the body now into the body then.
};

/// What an estimator knows of its surroundings [m, in W of Corrected()].
struct EstimatedMap {
  std::vector<Eigen::Vector3d> landmarks;  ///< Points that the cameras saw.
  std::vector<Eigen::Vector3d> sonar;      ///< Echoes of the sonar.
};

/// What an estimator wants to say of itself: initialised and from what, lost, recovered, how many
/// stamps it refused.
struct EstimatorEvent {
  Time t;               ///< Of the measurement at which it happened.
  std::string message;  ///< One line.
};

/// Takes measurements in the order of their arrival and says where the body is. Single-threaded and
/// deterministic: the same calls give the same answers. Nothing here throws for what a sensor said;
/// construction and Start() throw InputError for what a user wrote.
class Estimator {
 public:
  virtual ~Estimator() = default;

  /// Called once before the first measurement. With `known`, the estimator starts from this state
  /// and in its world frame; an estimator that cannot start without throws InputError.
  virtual void Start(const std::optional<NavState>& known) = 0;
  virtual void Add(const Measurement& measurement) = 0;
  /// No more measurements will come: final optimisation.
  virtual void Finish() {}

  /// Nothing before initialisation.
  virtual std::optional<NavEstimate> Latest() const = 0;
  /// Poses as they were published at the time.
  virtual const Trajectory& Odometry() const = 0;
  /// The best that is known now of the whole way; by default the odometry.
  virtual Trajectory Corrected() const { return Odometry(); }
  virtual std::vector<LoopClosure> Loops() const { return {}; }
  virtual EstimatedMap Map() const { return {}; }

  /// What has happened since the last call. Asked for after each Add() and after Finish().
  virtual std::vector<EstimatorEvent> TakeEvents() { return {}; }
  /// What the stages have cost so far; the one thing that is not deterministic.
  virtual EstimatorTimings Timings() const { return {}; }
};

}  // namespace drydock
