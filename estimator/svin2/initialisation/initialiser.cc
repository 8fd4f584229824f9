#include "estimator/svin2/initialisation/initialiser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "estimator/inertial/imu_integration.h"

namespace drydock::svin2 {
namespace {

VisualWindowConfig WindowConfig(const InitialiserConfig& config) {
  VisualWindowConfig vision = config.vision;
  vision.min_landmarks = config.min_landmarks;
  return vision;
}

// Before anything is computed: frames that show nothing end here.
bool HasEnough(const TrackedFrame& frame, int min_landmarks) {
  return std::count_if(frame.points.begin(), frame.points.end(),
                       [](const TrackedPoint& p) { return p.right.has_value(); }) >= min_landmarks;
}

double Furthest(const std::vector<Pose>& poses) {
  double furthest = 0.0;
  for (const Pose& pose : poses) {
    furthest = std::max(furthest, (pose.p() - poses.front().p()).norm());
  }
  return furthest;
}

// R_WV: z against gravity, yaw 0 for the body at the first frame.
Eigen::Quaterniond Level(const Alignment& alignment) {
  const auto upright =
      Eigen::Quaterniond::FromTwoVectors(-alignment.gravity_V, Eigen::Vector3d::UnitZ());
  const double yaw = YawOf(upright * alignment.T_VI.front().q());
  return FromYawPitchRoll(-yaw, 0.0, 0.0) * upright;
}

}  // namespace

Initialiser::Initialiser(const Config& config, const StereoSheet& stereo,
                         const ImuNoiseModel& imu_noise, const DepthSheet& depth)
    : config_(config),
      p_IC_(stereo.T_IC[0].p()),
      imu_noise_(imu_noise),
      depth_sheet_(depth),
      window_(stereo, WindowConfig(config)) {}

void Initialiser::Restart() {
  window_.Clear();
  deltas_.clear();
  imu_.clear();
  depth_.clear();
  Say(InitialiserStatus::kWaiting, "waiting for the first frame");
}

void Initialiser::Say(InitialiserStatus status, std::string why) {
  status_ = status;
  why_ = std::move(why);
}

std::optional<InitialisedStart> Initialiser::Add(const TrackedFrame& frame,
                                                 std::span<const TimedImuSample> imu,
                                                 std::span<const TimedDepth> depth) {
  Keep(imu, depth);
  if (!HasEnough(frame, config_.min_landmarks)) {
    Say(InitialiserStatus::kTooFewLandmarks,
        fmt::format("fewer than {} points in stereo", config_.min_landmarks));
    window_.Clear();
  } else if (window_.IsEmpty()) {
    BeginAnew(frame);
  } else if (IsDue(frame.t) && Extend(frame)) {
    auto start = Attempt();
    if (start.has_value()) {
      Restart();
      Say(InitialiserStatus::kStarted, start->report.Line());
      return start;
    }
  }
  if (window_.IsEmpty()) {
    Forget(frame.t, frame.t);
  } else {
    Forget(window_.At(window_.Size() - 1).t, window_.At(0).t);
  }
  return std::nullopt;
}

bool Initialiser::IsDue(Time t) const {
  return t - window_.At(window_.Size() - 1).t >= Duration::FromSeconds(config_.frame_spacing_s);
}

void Initialiser::Keep(std::span<const TimedImuSample> imu, std::span<const TimedDepth> depth) {
  for (const TimedImuSample& sample : imu) {
    if (imu_.empty() || sample.t > imu_.back().t) imu_.push_back(sample);
  }
  for (const TimedDepth& reading : depth) {
    if (depth_.empty() || reading.t > depth_.back().t) depth_.push_back(reading);
  }
}

// Of the IMU one more sample stays, to interpolate from.
void Initialiser::Forget(Time imu_before, Time depth_before) {
  auto first_needed = std::find_if(
      imu_.begin(), imu_.end(), [imu_before](const auto& sample) { return sample.t > imu_before; });
  if (first_needed != imu_.begin()) imu_.erase(imu_.begin(), first_needed - 1);
  std::erase_if(depth_, [depth_before](const auto& reading) { return reading.t < depth_before; });
}

void Initialiser::BeginAnew(const TrackedFrame& frame) {
  window_.Clear();
  deltas_.clear();
  window_.Add(frame, Eigen::Quaterniond::Identity());
}

// False, and a window that begins with `frame`, where it does not fit to those before.
bool Initialiser::Extend(const TrackedFrame& frame) {
  const Time last = window_.At(window_.Size() - 1).t;
  const auto begin_anew = [&](InitialiserStatus status, std::string why) {
    BeginAnew(frame);
    Say(status, std::move(why));
    return false;
  };
  const double gap = (frame.t - last).Seconds();
  if (gap > config_.max_gap_s) {
    return begin_anew(InitialiserStatus::kNoImu, fmt::format("no usable frame for {:.2f} s", gap));
  }
  const bool covered = !imu_.empty() && imu_.front().t < frame.t &&
                       frame.t - imu_.back().t < Duration::FromSeconds(imu_noise_.longest_step_s);
  auto delta =
      covered ? ImuPreintegration::Over(imu_, last, frame.t, {}, imu_noise_) : std::nullopt;
  if (!delta.has_value()) {
    return begin_anew(InitialiserStatus::kNoImu, "no IMU samples between two frames");
  }
  switch (window_.Add(frame, delta->delta().q)) {
    case FrameVerdict::kTooFewLandmarks:
      return begin_anew(InitialiserStatus::kTooFewLandmarks,
                        fmt::format("fewer than {} landmarks by stereo", config_.min_landmarks));
    case FrameVerdict::kNoPose:
      return begin_anew(InitialiserStatus::kNoPose, "landmarks do not agree on a motion");
    case FrameVerdict::kTurnDisagrees:
      return begin_anew(InitialiserStatus::kTurnDisagrees, "vision turns as the gyro does not");
    case FrameVerdict::kAdded:
      break;
  }
  deltas_.push_back(std::move(*delta));
  if (window_.Size() > config_.max_frames) {
    window_.DropOldest();
    deltas_.erase(deltas_.begin());
  }
  return true;
}

std::optional<InitialisedStart> Initialiser::Attempt() {
  if (window_.Size() < config_.min_frames) {
    Say(InitialiserStatus::kCollecting,
        fmt::format("{} of {} frames", window_.Size(), config_.min_frames));
    return std::nullopt;
  }
  const auto motion = window_.Adjust();
  if (!motion.has_value()) {
    Say(InitialiserStatus::kNoSolution, "the bundle adjustment has no solution");
    return std::nullopt;
  }
  InitialisationReport report;
  if (!CorrectGyro(*motion)) return std::nullopt;
  const auto alignment = AlignInSteps(*motion, report);
  if (!alignment.has_value()) {
    Say(InitialiserStatus::kNoSolution, "the alignment has no solution");
    return std::nullopt;
  }
  report.frames = window_.Size();
  report.seconds = (motion->t.back() - motion->t.front()).Seconds();
  report.travelled_m = Furthest(alignment->T_VI);
  report.at_rest = report.travelled_m < config_.moving_m;
  if (!Believes(*alignment) || WantsMore(*alignment, report.at_rest)) return std::nullopt;
  return StartFrom(*alignment, report);
}

bool Initialiser::CorrectGyro(const VisualMotion& motion) {
  const GyroBiasEstimate gyro = EstimateGyroBias(motion, deltas_, config_.gyro_bias_sigma);
  if (!(gyro.chi2 <= config_.max_chi2 * gyro.freedom)) {
    Say(InitialiserStatus::kGyroDisagrees,
        fmt::format("no gyro bias explains vision's turns: chi2 {:.0f} of {}", gyro.chi2,
                    gyro.freedom));
    return false;
  }
  ImuBias bias;
  bias.gyro = gyro.bias;
  for (ImuPreintegration& delta : deltas_) delta = delta.IntegratedAt(bias);
  return true;
}

// Depth needs to know which way is up, which the accelerometer says: so twice.
std::optional<Alignment> Initialiser::AlignInSteps(const VisualMotion& motion,
                                                   InitialisationReport& report) {
  AlignmentPriors priors{
      {1.0, config_.stereo_scale_sigma}, config_.gyro_bias_sigma, config_.accel_bias_sigma};
  report.depth_scale = priors.scale;
  auto alignment = Align(motion, deltas_, p_IC_, priors);
  if (!alignment.has_value()) return std::nullopt;
  if (depth_sheet_.rate_hz > 0.0) {
    const VisualHeights heights{motion.t, motion.T_VI, -alignment->gravity_V.normalized(),
                                alignment->tilt_sigma_rad};
    report.from_depth = ScaleFromDepth(depth_, heights, p_IC_, depth_sheet_, config_.depth);
    if (report.from_depth.has_value()) {
      priors.scale = Combine(priors.scale, *report.from_depth);
      report.depth_scale = priors.scale;
      alignment = Align(motion, deltas_, p_IC_, priors);
      if (!alignment.has_value()) return std::nullopt;
    }
  }
  report.alignment_scale = {alignment->scale.value / report.depth_scale.value,
                            alignment->scale.sigma / report.depth_scale.value};
  report.gravity_length = alignment->free_gravity;
  report.tilt_sigma_rad = alignment->tilt_sigma_rad;
  report.speed_sigma = alignment->speed_sigma;
  report.chi2_per_freedom = alignment->chi2 / alignment->freedom;
  report.bias = alignment->bias;
  return alignment;
}

bool Initialiser::Believes(const Alignment& alignment) {
  const double gravity_error = std::abs(alignment.free_gravity - kGravity.norm());
  if (!(gravity_error <= config_.max_gravity_error)) {
    Say(InitialiserStatus::kGravityImplausible,
        fmt::format("gravity would be {:.2f} m/s^2", alignment.free_gravity));
    return false;
  }
  if (!(alignment.chi2 <= config_.max_chi2 * alignment.freedom)) {
    Say(InitialiserStatus::kForceDisagrees,
        fmt::format("the accelerometer does not feel what vision sees: chi2 {:.0f} of {}",
                    alignment.chi2, alignment.freedom));
    return false;
  }
  if (!(alignment.tilt_sigma_rad <= config_.max_tilt_sigma_rad &&
        alignment.speed_sigma <= config_.max_speed_sigma)) {
    Say(InitialiserStatus::kUncertain,
        fmt::format("tilt is known to {:.4f} rad, speed to {:.3f} m/s", alignment.tilt_sigma_rad,
                    alignment.speed_sigma));
    return false;
  }
  return true;
}

bool Initialiser::WantsMore(const Alignment& alignment, bool at_rest) {
  const bool can_grow = window_.Size() < config_.max_frames;
  const double share = alignment.scale.sigma / alignment.scale.value;
  if (at_rest || !can_grow || share <= config_.wanted_scale_sigma) return false;
  Say(InitialiserStatus::kWantsScale, fmt::format("scale is known to {:.2f} %", 100.0 * share));
  return true;
}

InitialisedStart Initialiser::StartFrom(const Alignment& alignment,
                                        const InitialisationReport& report) const {
  const Eigen::Quaterniond q_WV = Level(alignment);
  const Pose T_WV(q_WV, -(q_WV * alignment.T_VI.front().p()));
  InitialisedStart start;
  for (int k = 0; k < window_.Size(); ++k) {
    start.frames.push_back({window_.At(k), T_WV * alignment.T_VI[k], q_WV * alignment.v_V[k]});
  }
  start.bias = alignment.bias;
  start.scale = alignment.scale.value;
  start.report = report;
  return start;
}

}  // namespace drydock::svin2
