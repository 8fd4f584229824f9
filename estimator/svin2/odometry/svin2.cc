#include "estimator/svin2/odometry/svin2.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/models/sonar_model.h"

namespace drydock::svin2 {
namespace {

/// A frame waits this long for the IMU samples up to its time.
constexpr Duration kLongestWait{50'000'000};
/// Samples this old may still serve an initialisation.
constexpr Duration kInitialisationSpan{10'000'000'000};

/// Biases at the start are as likely as the sheet says, where it does.
StartSigmas StartSigmasOf(const ImuSheet& sheet, const StartSigmas& config) {
  StartSigmas sigmas = config;
  if (sheet.gyro_turn_on_bias > 0.0) sigmas.speed_bias.gyro_bias = 2.0 * sheet.gyro_turn_on_bias;
  if (sheet.accel_turn_on_bias > 0.0) sigmas.speed_bias.accel_bias = 2.0 * sheet.accel_turn_on_bias;
  return sigmas;
}

/// The initialiser expects of the biases what the window does, where the sheet says it.
InitialiserConfig InitialiserOf(const ImuSheet& sheet, const SpeedBiasSigmas& sigmas,
                                InitialiserConfig initialiser) {
  if (sheet.gyro_turn_on_bias > 0.0) initialiser.gyro_bias_sigma = sigmas.gyro_bias;
  if (sheet.accel_turn_on_bias > 0.0) initialiser.accel_bias_sigma = sigmas.accel_bias;
  return initialiser;
}

DepthSheet InitialisersDepth(const Rig& rig, const Svin2Config& config) {
  DepthSheet sheet = rig.depth;
  if (!config.use_depth) sheet.rate_hz = 0.0;
  return sheet;
}

}  // namespace

Svin2::Svin2(const Rig& rig, const Svin2Config& config, Tracker tracker)
    : rig_(rig),
      config_(config),
      start_sigmas_(StartSigmasOf(rig.imu, config.start)),
      tracker_(std::move(tracker)),
      imu_(NoiseModelOf(rig.imu, config.imu_noise_inflation)),
      initialiser_(InitialiserOf(rig.imu, start_sigmas_.speed_bias, config.initialiser), rig.stereo,
                   imu_.noise(), InitialisersDepth(rig, config)),
      depths_(rig.depth, config.depth_gate),
      monitor_(config.tracking),
      habit_(config.habit),
      landmark_memory_(Duration::FromSeconds(config.sonar.memory_s)) {}

void Svin2::Start(const std::optional<NavState>& known) { known_ = known; }

void Svin2::Add(const Measurement& measurement) {
  if (const auto* imu = std::get_if<ImuSample>(&measurement.reading)) {
    if (!imu_.Add(measurement.t, *imu)) Refuse(measurement.t, refused_imu_, "an IMU sample");
  } else if (const auto* stereo = std::get_if<StereoFrame>(&measurement.reading)) {
    AddStereo(measurement, *stereo);
  } else if (const auto* depth = std::get_if<DepthSample>(&measurement.reading)) {
    if (config_.use_depth && !depths_.Add(measurement.t, *depth))
      Refuse(measurement.t, refused_depths_, "a depth reading");
  } else if (const auto* ping = std::get_if<SonarPing>(&measurement.reading)) {
    if (config_.use_sonar && rig_.HasSonar()) AddPing(measurement.t, *ping);
  }
  ProcessPending(measurement.t_arrival);
}

void Svin2::AddStereo(const Measurement& measurement, const StereoFrame& images) {
  if (last_frame_ && measurement.t <= *last_frame_) {
    Refuse(measurement.t, refused_frames_, "a stereo frame");
    return;
  }
  last_frame_ = measurement.t;
  frames_.push_back({measurement.t, measurement.t_arrival, images});
}

void Svin2::AddPing(Time t, const SonarPing& ping) {
  if (!std::isfinite(ping.range) || !std::isfinite(ping.head_angle) ||
      (last_ping_ && t <= *last_ping_)) {
    Refuse(t, refused_pings_, "a sonar ping");
    return;
  }
  last_ping_ = t;
  // No echo, or one beyond what the paper's authors found to be true.
  if (ping.range >= rig_.sonar.min_range_m && ping.range <= config_.sonar.max_range_m &&
      ping.range > 0.0)
    pings_.push_back({t, ping});
}

void Svin2::Refuse(Time t, int& count, const char* what) {
  if (++count == 1) Say(t, fmt::format("refused {}; more of them are counted only", what));
}

void Svin2::Finish() {
  for (; !frames_.empty(); frames_.pop_front()) Process(frames_.front());
  if (refused_imu_ + refused_frames_ + refused_depths_ + refused_pings_ > 0) {
    Say(last_tracked_.value_or(Time{}),
        fmt::format("refused in all: {} IMU samples, {} stereo frames, {} depth readings, {} pings",
                    refused_imu_, refused_frames_, refused_depths_, refused_pings_));
  }
}

void Svin2::ProcessPending(Time now) {
  while (!frames_.empty() &&
         (imu_.Covers(frames_.front().t) || now - frames_.front().t_arrival > kLongestWait)) {
    Process(frames_.front());
    frames_.pop_front();
  }
}

void Svin2::Process(const PendingFrame& pending) {
  if (window_) {
    Advance(pending);
  } else if (known_) {
    if (pending.t < known_->t) return;
    BeginFrom(*known_, pending);
  } else {
    Initialise(Track(pending, std::nullopt));
  }
  last_tracked_ = pending.t;
  depths_.NextFrame();
  imu_.ForgetBefore(pending.t - kInitialisationSpan);
}

TrackedFrame Svin2::Track(const PendingFrame& pending,
                          const std::optional<MotionPrediction>& prediction) {
  const StageClock::Lap lap(clock_, "front end");
  return tracker_(pending.t, pending.images, prediction, [this](LandmarkId id) {
    return window_ ? window_->LandmarkPosition(id) : std::nullopt;
  });
}

void Svin2::Advance(const PendingFrame& pending) {
  const NavState before = window_->Latest();
  const auto imu =
      imu_.Integrate(before.t, pending.t, ImuBias{before.gyro_bias, before.accel_bias});
  if (!imu) return;
  const NavState now = Propagate(before, *imu);
  const TrackedFrame seen = Track(pending, MotionPrediction{before.T_WI, now.T_WI});
  AddFrame(seen, *imu);
  Publish();
  if (monitor_.Status() == TrackingStatus::kLost) Initialise(seen);
}

void Svin2::AddFrame(const TrackedFrame& seen, const ImuPreintegration& imu) {
  const NavState before = window_->Latest();
  window_->AddFrame(seen, imu);
  if (monitor_.Status() == TrackingStatus::kLost) ExpectHabit(seen.t - before.t);
  UseDepths();
  UsePings(before, window_->Latest());
  {
    const StageClock::Lap lap(clock_, "optimisation");
    window_->Optimise();
  }
  const StageClock::Lap lap(clock_, "marginalisation");
  window_->Slide();
  const std::vector<Eigen::Vector3d> departed = window_->TakeDeparted();
  for (const Eigen::Vector3d& p_W : departed) landmarks_.push_back({seen.t, p_W});
  landmark_memory_.Add(seen.t, departed);
  NoteKeyframe(seen);
}

void Svin2::NoteKeyframe(const TrackedFrame& seen) {
  if (!config_.report_keyframes || !(seen.is_keyframe || seen.is_described)) return;
  // A new map begins some frames back, which the one before has reported: keyframes go on from
  // here.
  if (last_reported_ && seen.t <= *last_reported_) return;
  last_reported_ = seen.t;
  const StageClock::Lap lap(clock_, "keyframes for loops");
  Keyframe& keyframe = keyframes_.emplace_back(DescribeKeyframe(*window_, seen, tied_pings_));
  keyframe.is_glimpse = !seen.is_keyframe;
  if (seen.is_keyframe) ++last_keyframe_;
  keyframe.index = last_keyframe_;
  keyframe.map_id = map_id_;
}

void Svin2::Initialise(const TrackedFrame& seen) {
  const StageClock::Lap lap(clock_, "initialisation");
  const Time since = last_tracked_.value_or(seen.t - kLongestWait);
  const auto start = initialiser_.Add(seen, imu_.Between(since, seen.t), depths_.SinceLastFrame());
  if (!start) return;
  Say(seen.t, "initialised: " + start->report.Line());
  BeginFrom(*start);
}

void Svin2::BeginFrom(const NavState& known, const PendingFrame& pending) {
  NavState state = known;
  if (const auto imu = imu_.Integrate(known.t, pending.t, {known.gyro_bias, known.accel_bias}))
    state = Propagate(known, *imu);
  window_ = std::make_unique<SlidingWindow>(config_.window, StereoGeometry(rig_.stereo));
  const TrackedFrame seen = Track(pending, std::nullopt);
  window_->Start(state, start_sigmas_, seen);
  UseDepths();
  window_->Optimise();
  NoteKeyframe(seen);
  Publish();
}

void Svin2::BeginFrom(const InitialisedStart& start) {
  const InitialisedFrame& origin = start.frames.front();
  const Pose T_W_start = Placement(origin.tracked.t, origin.T_WI.q());
  if (window_) ++map_id_;
  const auto state_of = [&](const InitialisedFrame& frame) {
    NavState state;
    state.t = frame.tracked.t;
    // The window sees by the rig's own scale.
    const Pose T_start_I(frame.T_WI.q(), frame.T_WI.p() / start.scale);
    state.T_WI = T_W_start * T_start_I;
    state.v_W = T_W_start.q() * frame.v_W / start.scale;
    state.gyro_bias = start.bias.gyro;
    state.accel_bias = start.bias.accel;
    return state;
  };
  TrackedFrame first = origin.tracked;
  first.is_keyframe = true;
  window_ = std::make_unique<SlidingWindow>(config_.window, StereoGeometry(rig_.stereo));
  window_->Start(state_of(origin), start_sigmas_, first, ImuBias{});
  UseDepths();
  tied_pings_.clear();
  NoteKeyframe(first);
  monitor_.Restart();
  for (std::size_t k = 1; k < start.frames.size(); ++k) {
    const NavState before = window_->Latest();
    const auto imu =
        imu_.Integrate(before.t, start.frames[k].tracked.t, {before.gyro_bias, before.accel_bias});
    if (imu) AddFrame(start.frames[k].tracked, *imu);
  }
  Publish();
}

/// Where a map that begins at `t` with the body at its origin, turned by `q`, is laid in W: as it
/// is or, after another map, where that one thought the body to be, upright.
Pose Svin2::Placement(Time t, const Eigen::Quaterniond& q) const {
  const auto last = Interpolate(odometry_, t);
  if (!last) return Pose::Identity();
  return {FromYawPitchRoll(YawBetween(q, last->q()), 0.0, 0.0), last->p()};
}

void Svin2::UseDepths() {
  for (EstimatorEvent& event : depths_.Feed(*window_, imu_)) events_.push_back(std::move(event));
}

void Svin2::ExpectHabit(Duration since_last) {
  if (const auto sigma = habit_.SigmaEach(since_last)) window_->AddVelocity(habit_.v_I(), *sigma);
}

void Svin2::UsePings(const NavState& before, const NavState& now) {
  const StageClock::Lap lap(clock_, "sonar");
  // Pings of one sweep hit the same face: the surest one says what they all say.
  std::optional<SonarPatch> best;
  SonarRangeObservation observation;
  tied_pings_.clear();
  for (; !pings_.empty() && pings_.front().t <= now.t; pings_.pop_front()) {
    const auto& [t, ping] = pings_.front();
    const auto imu = imu_.Integrate(before.t, t, {before.gyro_bias, before.accel_bias});
    if (!imu) continue;
    const Pose T_WI = Propagate(before, *imu).T_WI;
    const Pose T_WS = T_WI * rig_.sonar.T_IS;
    const PingRay ray{T_WS.p(), T_WS.q() * SonarBeam(ping.head_angle), ping.range};
    echoes_.push_back({t, ray.head_W + ray.range * ray.direction_W});
    const auto patch = PatchOf(ray);
    if (!patch || (best && patch->sigma >= best->sigma)) continue;
    best = patch;
    observation.range = ping.range + patch->range_correction;
    observation.T_frame_ping = now.T_WI.Inverse() * T_WI;
  }
  if (!best) return;
  observation.p_IS = rig_.sonar.T_IS.p();
  observation.sigma_range = SonarRangeSigma(rig_.sonar);
  observation.sigma_patch = best->sigma;
  CheckRigScale(now.t, observation, best->innovation);
  std::vector<LandmarkId> estimated;
  std::vector<Eigen::Vector3d> departed;
  for (const PatchCandidate& member : best->members) {
    if (member.id) {
      estimated.push_back(*member.id);
    } else {
      departed.push_back(member.p_W);
    }
  }
  if (departed.empty()) tied_pings_.push_back({observation, estimated});
  window_->AddSonar(observation, estimated, departed);
}

void Svin2::CheckRigScale(Time t, const SonarRangeObservation& ping, double innovation) {
  // Drift in the dark is no matter of the rig.
  if (monitor_.Status() != TrackingStatus::kTracking) return;
  rig_scale_.Add(ping.range, innovation, std::hypot(ping.sigma_range, ping.sigma_patch));
  if (const auto complaint = rig_scale_.Complaint()) Say(t, *complaint);
}

std::optional<SonarPatch> Svin2::PatchOf(const PingRay& ping) const {
  const Eigen::Vector3d echo = ping.head_W + ping.range * ping.direction_W;
  const double radius = PatchRadius(ping, config_.sonar.patch);
  std::vector<PatchCandidate> candidates;
  landmark_memory_.ForEachNear(echo, radius, [&](const Eigen::Vector3d& p_W) {
    candidates.push_back({p_W, std::nullopt});
  });
  window_->ForEachLandmark([&](LandmarkId id, const Eigen::Vector3d& p_W) {
    if ((p_W - echo).squaredNorm() <= radius * radius) candidates.push_back({p_W, id});
  });
  return FindSonarPatch(ping, candidates, config_.sonar.patch);
}

void Svin2::Publish() {
  NavEstimate estimate;
  estimate.state = window_->Latest();
  {
    const StageClock::Lap lap(clock_, "covariance");
    estimate.pose_covariance = window_->LatestCovariance();
  }
  estimate.status = monitor_.Update(estimate.state.t, window_->LandmarksInView());
  if (estimate.status == TrackingStatus::kTracking) habit_.Learn(estimate.state);
  estimate.map_id = map_id_;
  latest_ = estimate;
  odometry_.push_back({estimate.state.t, estimate.state.T_WI});
}

EstimatedMap Svin2::Map() const {
  EstimatedMap map;
  const auto position = [](const TimedPoint& point) { return point.p_W; };
  std::ranges::transform(landmarks_, std::back_inserter(map.landmarks), position);
  std::ranges::transform(echoes_, std::back_inserter(map.sonar), position);
  return map;
}

void Svin2::Say(Time t, std::string message) { events_.push_back({t, std::move(message)}); }

std::vector<EstimatorEvent> Svin2::TakeEvents() { return std::exchange(events_, {}); }

std::unique_ptr<Svin2> MakeSvin2(const Rig& rig, const Svin2Config& config) {
  const auto tracker = std::make_shared<FeatureTracker>(config.frontend, rig.stereo);
  return std::make_unique<Svin2>(
      rig, config,
      [tracker](Time t, const StereoFrame& images, const std::optional<MotionPrediction>& motion,
                const LandmarkLookup& landmarks) {
        return tracker->Track(t, images, motion, landmarks);
      });
}

}  // namespace drydock::svin2
