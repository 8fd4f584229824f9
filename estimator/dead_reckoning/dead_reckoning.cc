#include "estimator/dead_reckoning/dead_reckoning.h"

#include <cmath>

#include "estimator/inertial/imu_integration.h"
#include "sensors_models/base/check.h"
#include "sensors_models/models/pressure_model.h"

namespace drydock {

DeadReckoning::DeadReckoning(const Rig& rig, const VerticalFilter::Config& config)
    : rig_(rig), vertical_filter_(config) {}

void DeadReckoning::Start(const std::optional<NavState>& known) {
  if (!known) throw InputError("dead-reckoning has to be told where it starts");
  state_ = *known;
  started_ = true;
}

void DeadReckoning::Add(const Measurement& measurement) {
  if (!started_) return;
  if (const auto* imu = std::get_if<ImuSample>(&measurement.reading)) AddImu(measurement.t, *imu);
  if (const auto* depth = std::get_if<DepthSample>(&measurement.reading))
    AddDepth(measurement.t, *depth);
}

void DeadReckoning::AddImu(Time t, const ImuSample& sample) {
  if (!sample.angular_rate.allFinite() || !sample.specific_force.allFinite()) return;
  if (!last_imu_) {
    if (t < state_.t) return;
    // The body is taken to have stood still relative to this first sample since the known instant.
    last_imu_ = sample;
  }
  if (t > state_.t) {
    const double dt = (t - state_.t).Seconds();
    state_ = IntegrateMidpoint(state_, *last_imu_, sample, t);
    const Eigen::Vector3d error(0.0, 0.0, vertical_acceleration_error_);
    state_.T_WI = Pose(state_.T_WI.q(), state_.T_WI.p() + 0.5 * error * dt * dt);
    state_.v_W += error * dt;
    vertical_filter_.Predict(dt);
  } else if (t < state_.t || !odometry_.empty()) {
    return;
  }
  last_imu_ = sample;
  odometry_.push_back({t, state_.T_WI});
}

void DeadReckoning::AddDepth(Time t, const DepthSample& sample) {
  if (!std::isfinite(sample.depth)) return;
  // How the body moved before the known instant is not known.
  if (odometry_.empty() && t < state_.t) return;
  // A reading is older than the state by its latency at most: carry it over by the vertical speed.
  const double age = (state_.t - t).Seconds();
  const double depth_now = sample.depth - state_.v_W.z() * age;
  if (!surface_z_) {
    surface_z_ = depth_now + (state_.T_WI * rig_.depth.p_ID).z();
    return;
  }
  const double predicted = DepthBelowSurface(state_.T_WI, rig_.depth.p_ID, *surface_z_);
  const Eigen::Vector3d correction = vertical_filter_.Update(predicted - depth_now);
  state_.T_WI = Pose(state_.T_WI.q(), state_.T_WI.p() + Eigen::Vector3d(0.0, 0.0, correction[0]));
  state_.v_W.z() += correction[1];
  vertical_acceleration_error_ += correction[2];
}

std::optional<NavEstimate> DeadReckoning::Latest() const {
  if (odometry_.empty()) return std::nullopt;
  NavEstimate estimate;
  estimate.state = state_;
  estimate.status = TrackingStatus::kDeadReckoning;
  return estimate;
}

}  // namespace drydock
