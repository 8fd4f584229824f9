#include "estimator/svin2/odometry/svin2.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace drydock::svin2 {
namespace {

/// A frame waits this long for the IMU samples up to its time.
constexpr Duration kLongestWait{50'000'000};
/// Without a frame for this long it goes on by the other sensors.
constexpr Duration kLongestSilence{500'000'000};
/// A frame that is later than that comes to nothing, if it is the first one after a silence.
constexpr Duration kLatestFrame{200'000'000};
/// Samples this old may still serve an initialisation.
constexpr Duration kInitialisationSpan{10'000'000'000};

/// Biases at the start are within twice what the sheet says, where it does.
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
      sonar_(rig.sonar, config.sonar),
      monitor_(config.tracking),
      habit_(config.habit) {}

void Svin2::Start(const std::optional<NavState>& known) { known_ = known; }

void Svin2::Add(const Measurement& measurement) {
  if (const auto* imu = std::get_if<ImuSample>(&measurement.reading)) {
    if (!imu_.Add(measurement.t, *imu)) Refuse(measurement.t, refused_imu_, "an IMU sample");
  } else if (const auto* stereo = std::get_if<StereoFrame>(&measurement.reading)) {
    AddStereo(measurement, *stereo);
  } else if (const auto* depth = std::get_if<DepthSample>(&measurement.reading)) {
    if (config_.use_depth && rig_.HasDepth() && !depths_.Add(measurement.t, *depth))
      Refuse(measurement.t, refused_depths_, "a depth reading");
  } else if (const auto* ping = std::get_if<SonarPing>(&measurement.reading)) {
    if (config_.use_sonar && rig_.HasSonar() && !sonar_.Add(measurement.t, *ping))
      Refuse(measurement.t, refused_pings_, "a sonar ping");
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
  if (frames_.empty()) SitOutSilence(now);
}

/// A camera that says nothing sees nothing.
void Svin2::SitOutSilence(Time now) {
  if (!window_) {
    if (!known_) imu_.ForgetBefore(now - kInitialisationSpan);
    return;
  }
  const Time t = *last_tracked_ + kLongestSilence;
  if (now < t + kLatestFrame || !imu_.Covers(t)) return;
  last_frame_ = t;
  Process({t, now, std::nullopt});
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
  const StageClock::Lap lap(clock_, pending.images ? "front end" : "silence of the cameras");
  const StereoFrame images = pending.images.value_or(StereoFrame{});
  return tracker_(pending.t, images, prediction, [this](LandmarkId id) {
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
  Publish(seen);
  if (monitor_.Status() == TrackingStatus::kLost) Initialise(seen);
}

void Svin2::AddFrame(const TrackedFrame& seen, const ImuPreintegration& imu) {
  const NavState before = window_->Latest();
  window_->AddFrame(seen, imu);
  if (monitor_.Status() == TrackingStatus::kLost) ExpectHabit(seen.t - before.t);
  UseDepths();
  UsePings(before);
  {
    const StageClock::Lap lap(clock_, "optimisation");
    window_->Optimise();
  }
  const StageClock::Lap lap(clock_, "marginalisation");
  window_->Slide();
  const std::vector<Eigen::Vector3d> departed = window_->TakeDeparted();
  for (const Eigen::Vector3d& p_W : departed) landmarks_.push_back({seen.t, p_W});
  sonar_.Remember(seen.t, departed);
  NoteKeyframe(seen);
}

void Svin2::NoteKeyframe(const TrackedFrame& seen) {
  if (!config_.report_keyframes || !(seen.is_keyframe || seen.is_described)) return;
  // A new map begins some frames back, which the one before has reported: keyframes go on from
  // here.
  if (last_reported_ && seen.t <= *last_reported_) return;
  last_reported_ = seen.t;
  const StageClock::Lap lap(clock_, "keyframes for loops");
  Keyframe& keyframe = keyframes_.emplace_back(DescribeKeyframe(*window_, seen, sonar_.tied()));
  keyframe.is_glimpse = !seen.is_keyframe;
  if (seen.is_keyframe) ++last_keyframe_;
  keyframe.index = last_keyframe_;
  keyframe.map_id = map_id_;
}

void Svin2::Initialise(const TrackedFrame& seen) {
  const Time since = last_tracked_.value_or(seen.t - kLongestWait);
  std::optional<InitialisedStart> start;
  {
    const StageClock::Lap lap(clock_, "initialisation");
    start = initialiser_.Add(seen, imu_.Between(since, seen.t), depths_.SinceLastFrame());
  }
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
  Publish(seen);
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
  sonar_.StartMap();
  NoteKeyframe(first);
  monitor_.Restart();
  for (std::size_t k = 1; k < start.frames.size(); ++k) {
    const NavState before = window_->Latest();
    const auto imu =
        imu_.Integrate(before.t, start.frames[k].tracked.t, {before.gyro_bias, before.accel_bias});
    if (imu) AddFrame(start.frames[k].tracked, *imu);
  }
  Publish(start.frames.back().tracked);
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

void Svin2::UsePings(const NavState& before) {
  const StageClock::Lap lap(clock_, "sonar");
  const bool is_tracking = monitor_.Status() == TrackingStatus::kTracking;
  for (EstimatorEvent& event : sonar_.Feed(*window_, imu_, before, is_tracking))
    events_.push_back(std::move(event));
}

void Svin2::Publish(const TrackedFrame& seen) {
  NavEstimate estimate;
  estimate.state = window_->Latest();
  {
    const StageClock::Lap lap(clock_, "covariance");
    estimate.pose_covariance = window_->LatestCovariance();
  }
  const TrackingStatus before = monitor_.Status();
  estimate.status = monitor_.Update(estimate.state.t, window_->SeesEnough());
  estimate.vision = {window_->LandmarksInView(), seen.tracked, seen.empty_quadrants};
  SayStatus(before, estimate);
  if (estimate.status == TrackingStatus::kTracking) habit_.Learn(estimate.state);
  estimate.map_id = map_id_;
  latest_ = estimate;
  // Where a new map begins, the lost one has published this frame already.
  if (!odometry_.empty() && odometry_.back().t == estimate.state.t) {
    odometry_.pop_back();
    position_sigmas_.pop_back();
  }
  odometry_.push_back({estimate.state.t, estimate.state.T_WI});
  const double last_sigma = position_sigmas_.empty() ? 0.0 : position_sigmas_.back();
  position_sigmas_.push_back(
      estimate.pose_covariance
          ? std::sqrt(std::max(0.0, estimate.pose_covariance->topLeftCorner<3, 3>().trace()))
          : last_sigma);
}

void Svin2::SayStatus(TrackingStatus before, const NavEstimate& now) {
  if (now.status == before) return;
  const Time t = now.state.t;
  if (now.status == TrackingStatus::kDeadReckoning) {
    Say(t, fmt::format("vision failed ({} landmarks in view, {} of 4 quadrants empty): on by "
                       "inertia and depth",
                       now.vision->landmarks_in_view, now.vision->empty_quadrants));
  } else if (now.status == TrackingStatus::kLost) {
    Say(t, "lost: too long without vision");
  } else if (before == TrackingStatus::kDeadReckoning) {
    Say(t, fmt::format("vision is back ({} landmarks in view)", now.vision->landmarks_in_view));
  }
}

EstimatedMap Svin2::Map() const {
  EstimatedMap map;
  const auto position = [](const TimedPoint& point) { return point.p_W; };
  std::ranges::transform(landmarks_, std::back_inserter(map.landmarks), position);
  std::ranges::transform(Echoes(), std::back_inserter(map.sonar), position);
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
