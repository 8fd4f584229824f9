// The baseline that every other estimator must beat: inertial navigation, held in height by
// pressure.
#pragma once

#include <optional>

#include "estimator/dead_reckoning/vertical_filter.h"
#include "estimator/interface/estimator.h"
#include "sensors_models/measurement/rig.h"

namespace drydock {

/// Integrates the IMU from a known state by the midpoint rule and corrects height, vertical speed
/// and vertical acceleration by depth readings, relative to the first one. Publishes a pose at each
/// IMU sample. Readings that are not finite or that run backwards in time are ignored.
class DeadReckoning final : public Estimator {
 public:
  explicit DeadReckoning(const Rig& rig, const VerticalFilter::Config& config = {});

  /// InputError without a known state.
  void Start(const std::optional<NavState>& known) override;
  void Add(const Measurement& measurement) override;
  std::optional<NavEstimate> Latest() const override;
  const Trajectory& Odometry() const override { return odometry_; }

 private:
  void AddImu(Time t, const ImuSample& sample);
  void AddDepth(Time t, const DepthSample& sample);

  Rig rig_;
  NavState state_;
  VerticalFilter vertical_filter_;
  double vertical_acceleration_error_ = 0.0;  ///< What AddImu subtracts [m/s^2], in W.
  std::optional<ImuSample> last_imu_;
  std::optional<double> surface_z_;  ///< From the first depth reading [m], in W.
  bool started_ = false;
  Trajectory odometry_;
};

}  // namespace drydock
