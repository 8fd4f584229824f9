#include "estimator/svin2/odometry/svin2.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drydock::svin2 {
namespace {

/// A frame waits this long for the IMU samples up to its time.
constexpr Duration kLongestWait = Duration{50'000'000};

}  // namespace

ImuNoiseModel NoiseModelOf(const ImuSheet& sheet, double inflation) {
  ImuNoiseModel noise;
  const auto inflate = [inflation](double& value, double of_sheet) {
    if (of_sheet > 0.0) value = inflation * of_sheet;
  };
  inflate(noise.gyro_noise_density, sheet.gyro_noise_density);
  inflate(noise.accel_noise_density, sheet.accel_noise_density);
  inflate(noise.gyro_bias_walk, sheet.gyro_bias_walk);
  inflate(noise.accel_bias_walk, sheet.accel_bias_walk);
  noise.gyro_range = sheet.gyro_range;
  noise.accel_range = sheet.accel_range;
  return noise;
}

Svin2::Svin2(const Rig& rig, const Svin2Config& config, Tracker tracker)
    : rig_(rig),
      config_(config),
      tracker_(std::move(tracker)),
      imu_(NoiseModelOf(rig.imu, config.imu_noise_inflation)),
      window_(config.window, StereoGeometry(rig.stereo)) {}

void Svin2::Start(const std::optional<NavState>& known) { known_ = known; }

void Svin2::Add(const Measurement& measurement) {
  if (const auto* imu = std::get_if<ImuSample>(&measurement.reading)) {
    imu_.Add(measurement.t, *imu);
  } else if (const auto* stereo = std::get_if<StereoFrame>(&measurement.reading)) {
    frames_.push_back({measurement.t, measurement.t_arrival, *stereo});
  } else if (const auto* depth = std::get_if<DepthSample>(&measurement.reading)) {
    if (config_.use_depth && std::isfinite(depth->depth))
      depths_.push_back({measurement.t, depth->depth});
  }
  ProcessPending(measurement.t_arrival);
}

void Svin2::Finish() {
  while (!frames_.empty()) {
    Process(frames_.front());
    frames_.pop_front();
  }
}

void Svin2::ProcessPending(Time now) {
  while (!frames_.empty() &&
         (imu_.Covers(frames_.front().t) || now - frames_.front().t_arrival > kLongestWait)) {
    Process(frames_.front());
    frames_.pop_front();
  }
}

ImuBias Svin2::Bias() const {
  const NavState latest = window_.Latest();
  return {latest.gyro_bias, latest.accel_bias};
}

void Svin2::StartFrom(const NavState& known, const PendingFrame& pending) {
  NavState state = known;
  if (const auto imu = imu_.Integrate(known.t, pending.t, {known.gyro_bias, known.accel_bias}))
    state = Propagate(known, *imu);
  window_.Start(state, config_.start, Track(pending, std::nullopt));
}

TrackedFrame Svin2::Track(const PendingFrame& pending,
                          const std::optional<MotionPrediction>& prediction) {
  const StageClock::Lap lap(clock_, "front end");
  return tracker_(pending.t, pending.frame, prediction,
                  [this](LandmarkId id) { return window_.LandmarkPosition(id); });
}

void Svin2::Process(const PendingFrame& pending) {
  if (!window_.IsStarted()) {
    if (!known_ || pending.t < known_->t) return;
    StartFrom(*known_, pending);
  } else {
    const NavState before = window_.Latest();
    const auto imu = imu_.Integrate(before.t, pending.t, Bias());
    if (!imu) return;
    const MotionPrediction prediction{before.T_WI, window_.Predict(*imu).T_WI};
    window_.AddFrame(Track(pending, prediction), *imu);
  }
  AddPendingDepths(pending.t);
  {
    const StageClock::Lap lap(clock_, "optimisation");
    window_.Optimise();
  }
  Publish();
  {
    const StageClock::Lap lap(clock_, "marginalisation");
    window_.Slide();
  }
  imu_.ForgetBefore(pending.t);
}

void Svin2::AddPendingDepths(Time until) {
  while (!depths_.empty() && depths_.front().t <= until) {
    const PendingDepth reading = depths_.front();
    depths_.pop_front();
    if (!depth_reference_) {
      const double height = (window_.Latest().T_WI * rig_.depth.p_ID).z();
      depth_reference_ = DepthReference{reading.depth, height};
      continue;
    }
    const double rounding = rig_.depth.resolution_m / std::sqrt(12.0);
    const double sigma = std::hypot(std::max(rig_.depth.noise_m, 1e-3), rounding, 2e-3);
    window_.AddDepth(reading.t, {reading.depth, rig_.depth.p_ID, {}, sigma}, *depth_reference_);
  }
}

void Svin2::Publish() {
  NavEstimate estimate;
  estimate.state = window_.Latest();
  {
    const StageClock::Lap lap(clock_, "covariance");
    estimate.pose_covariance = window_.LatestCovariance();
  }
  estimate.status = TrackingStatus::kTracking;
  latest_ = estimate;
  odometry_.push_back({estimate.state.t, estimate.state.T_WI});
}

std::optional<NavEstimate> Svin2::Latest() const { return latest_; }

}  // namespace drydock::svin2
