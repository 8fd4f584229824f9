#include "estimator/svin2/window/sliding_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "estimator/svin2/factors/body_velocity_factor.h"
#include "estimator/svin2/factors/imu_factor.h"
#include "estimator/svin2/factors/reprojection_factor.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

/// Of a body that swims, beyond which it rises evenly [m/s^2].
constexpr double kVerticalAcceleration = 0.5;

ImuBias BiasOf(const NavState& state) { return {state.gyro_bias, state.accel_bias}; }

SpeedBias SpeedBiasOf(const NavState& state) { return {state.v_W, BiasOf(state)}; }

Eigen::Matrix<double, 6, 6> StartWhitening(const StartSigmas& sigmas) {
  Vector6d all;
  all << sigmas.position, sigmas.position, sigmas.position, sigmas.roll_pitch, sigmas.roll_pitch,
      sigmas.yaw;
  return PoseWhitening(all);
}

}  // namespace

SlidingWindow::SlidingWindow(const WindowConfig& config, const StereoGeometry& geometry)
    : config_(config), geometry_(geometry) {}

void SlidingWindow::Start(const NavState& state, const StartSigmas& sigmas,
                          const TrackedFrame& seen, const std::optional<ImuBias>& expected_bias) {
  Check(!IsStarted(), "the window has been started already");
  const Frame& frame = AddState(state, seen);
  graph_.AddFactor(std::make_unique<PosePriorFactor>(state.T_WI, StartWhitening(sigmas)),
                   {frame.pose});
  const SpeedBias expected = {state.v_W, expected_bias.value_or(BiasOf(state))};
  graph_.AddFactor(std::make_unique<SpeedBiasPriorFactor>(expected, sigmas.speed_bias),
                   {*frame.speed_bias});
  AddObservations(frame, seen);
}

void SlidingWindow::AddFrame(const TrackedFrame& seen, const ImuPreintegration& imu) {
  const Frame before = frames_.back();
  Frame& frame = AddState(Propagate(Latest(), imu), seen);
  Link(before, frame, imu);
  AddObservations(frame, seen);
}

void SlidingWindow::Link(const Frame& before, Frame& frame, const ImuPreintegration& imu) {
  const FactorId factor =
      graph_.AddFactor(std::make_unique<ImuFactor>(imu),
                       {before.pose, *before.speed_bias, frame.pose, *frame.speed_bias});
  frame.imu = ImuLink{factor, imu};
}

SlidingWindow::Frame& SlidingWindow::AddState(const NavState& state, const TrackedFrame& seen) {
  Frame frame;
  frame.index = next_index_++;
  frame.t = state.t;
  frame.is_keyframe = seen.is_keyframe;
  frame.pose = graph_.AddPose(state.T_WI);
  frame.speed_bias = graph_.AddBlock(ToParameters(SpeedBiasOf(state)));
  frames_.push_back(frame);
  return frames_.back();
}

void SlidingWindow::AddObservations(const Frame& frame, const TrackedFrame& seen) {
  for (const TrackedPoint& tracked : seen.points) {
    Point& point = points_[tracked.id];
    const auto add = [&](int camera, const Eigen::Vector2d& pixel) {
      point.observations.push_back({frame.index, camera, pixel, tracked.sigma_px, std::nullopt});
      if (point.landmark) AddReprojection(point, point.observations.back());
    };
    add(0, tracked.left);
    if (tracked.right) add(1, *tracked.right);
  }
}

void SlidingWindow::AddReprojection(Point& point, Observation& observation) {
  const int camera = observation.camera;
  observation.factor = graph_.AddFactor(
      std::make_unique<ReprojectionFactor>(geometry_.camera(camera), geometry_.T_IC(camera),
                                           observation.pixel, observation.sigma_px),
      {FrameAt(observation.frame).pose, *point.landmark}, config_.cauchy_scale);
}

void SlidingWindow::TriangulateNewLandmarks() {
  const std::int64_t newest = frames_.back().index;
  for (auto& [id, point] : points_) {
    if (point.landmark || point.observations.size() < 2) continue;
    if (point.observations.back().frame != newest) continue;
    std::vector<View> views;
    views.reserve(point.observations.size());
    for (const Observation& seen : point.observations) {
      views.push_back({&geometry_.camera(seen.camera),
                       graph_.PoseOf(FrameAt(seen.frame).pose) * geometry_.T_IC(seen.camera),
                       seen.pixel, seen.sigma_px});
    }
    const Triangulation found = Triangulate(views, config_.triangulation);
    if (!found.IsGood()) continue;
    point.landmark = graph_.AddBlock({found.p_W.data(), 3});
    for (Observation& seen : point.observations) AddReprojection(point, seen);
  }
}

void SlidingWindow::AddDepth(Time t, DepthObservation observation, const Eigen::Vector3d& rate_I) {
  const Frame& frame = NearestMoving(t);
  const double dt = (t - frame.t).Seconds();
  observation.since_frame = t - frame.t;
  // The port as the frame's body would have it at the time of the reading.
  observation.p_ID = ExpSO3(dt * rate_I) * observation.p_ID;
  observation.sigma = std::hypot(observation.sigma, 0.5 * kVerticalAcceleration * dt * dt);
  if (!surface_) {
    const NavState state = StateOf(frame);
    const double height = (state.T_WI * observation.p_ID).z() + state.v_W.z() * dt;
    surface_ = graph_.AddBlock(std::array{height + observation.depth});
  }
  graph_.AddFactor(std::make_unique<DepthFactor>(observation),
                   {frame.pose, *frame.speed_bias, *surface_});
}

std::optional<double> SlidingWindow::SurfaceHeight() const {
  return surface_ ? std::optional(graph_.Values(*surface_).front()) : std::nullopt;
}

void SlidingWindow::AddVelocity(const Eigen::Vector3d& v_I, double sigma) {
  const Frame& latest = frames_.back();
  graph_.AddFactor(std::make_unique<BodyVelocityFactor>(v_I, sigma),
                   {latest.pose, *latest.speed_bias});
}

void SlidingWindow::AddSonar(SonarRangeObservation observation, std::vector<LandmarkId> estimated,
                             std::span<const Eigen::Vector3d> departed) {
  const Frame &oldest = frames_.front(), &latest = frames_.back();
  if (oldest.index == latest.index) return;
  Ping ping{latest.index, oldest.index, std::move(observation), std::move(estimated), {}};
  for (const Eigen::Vector3d& p_W : departed) Hold(ping, p_W);
  ping.factor = AddFactorOf(ping);
  pings_.push_back(std::move(ping));
}

FactorId SlidingWindow::AddFactorOf(const Ping& ping) {
  std::vector<BlockId> blocks = {FrameAt(ping.frame).pose};
  if (!ping.observation.held_landmarks.empty()) blocks.push_back(FrameAt(ping.anchor).pose);
  for (const LandmarkId id : ping.estimated) blocks.push_back(*points_.at(id).landmark);
  return graph_.AddFactor(
      std::make_unique<SonarRangeFactor>(ping.observation, ping.estimated.size()), blocks,
      config_.cauchy_scale);
}

void SlidingWindow::Hold(Ping& ping, const Eigen::Vector3d& p_W) const {
  const Pose T_WA = graph_.PoseOf(FrameAt(ping.anchor).pose);
  ping.observation.held_landmarks.push_back(T_WA.Inverse() * p_W);
}

void SlidingWindow::HoldLandmarks(Ping& ping, const std::function<bool(LandmarkId)>& which) {
  std::vector<LandmarkId> still_estimated;
  for (const LandmarkId id : ping.estimated) {
    if (which(id)) {
      Hold(ping, PositionOf(points_.at(id)));
    } else {
      still_estimated.push_back(id);
    }
  }
  if (still_estimated.size() == ping.estimated.size()) return;
  ping.estimated = still_estimated;
  graph_.RemoveFactor(ping.factor);
  ping.factor = AddFactorOf(ping);
}

/// Before a frame is marginalised: its pings then have a say in what is left of it.
void SlidingWindow::HoldPingsOf(std::int64_t frame) {
  std::erase_if(pings_, [&](Ping& ping) {
    if (ping.frame != frame && ping.anchor != frame) return false;
    HoldLandmarks(ping, [](LandmarkId) { return true; });
    return true;
  });
}

void SlidingWindow::Depart(LandmarkId id, const Point& point) {
  departed_.push_back(PositionOf(point));
  for (Ping& ping : pings_) HoldLandmarks(ping, [id](LandmarkId other) { return other == id; });
}

std::vector<Eigen::Vector3d> SlidingWindow::TakeDeparted() { return std::exchange(departed_, {}); }

Eigen::Vector3d SlidingWindow::PositionOf(const Point& point) const {
  return Eigen::Map<const Eigen::Vector3d>(graph_.Values(*point.landmark).data());
}

SolverReport SlidingWindow::Optimise() {
  RenewImuFactors();
  TriangulateNewLandmarks();
  const SolverReport report = graph_.Optimise(config_.solver);
  RejectOutliers();
  return report;
}

void SlidingWindow::RenewImuFactors() {
  for (std::size_t k = 1; k < frames_.size(); ++k) {
    if (!frames_[k].imu) continue;
    const ImuBias bias = BiasOf(StateOf(frames_[k - 1]));
    if (!frames_[k].imu->preintegration.NeedsReintegration(bias)) continue;
    const ImuPreintegration anew = frames_[k].imu->preintegration.IntegratedAt(bias);
    graph_.RemoveFactor(frames_[k].imu->factor);
    Link(frames_[k - 1], frames_[k], anew);
  }
}

void SlidingWindow::RejectOutliers() {
  for (auto& [id, point] : points_) {
    if (!point.landmark) continue;
    std::erase_if(point.observations, [&](const Observation& seen) {
      if (graph_.ChiSquare(*seen.factor) <= config_.max_reprojection_chi2) return false;
      graph_.RemoveFactor(*seen.factor);
      return true;
    });
  }
  DropUnseenPoints();
}

void SlidingWindow::DropObservations(std::int64_t frame) {
  for (auto& [id, point] : points_) {
    std::erase_if(point.observations, [&](const Observation& seen) {
      if (seen.frame != frame) return false;
      if (seen.factor) graph_.RemoveFactor(*seen.factor);
      return true;
    });
  }
  DropUnseenPoints();
}

void SlidingWindow::DropUnseenPoints() {
  for (auto at = points_.begin(); at != points_.end();) {
    const Point& point = at->second;
    const std::size_t needed = point.landmark ? 2 : 1;
    if (point.observations.size() >= needed) {
      ++at;
      continue;
    }
    if (point.landmark) {
      Depart(at->first, point);
      graph_.RemoveBlock(*point.landmark);
    }
    at = points_.erase(at);
  }
}

void SlidingWindow::Slide() {
  while (NumRecent() > config_.recent_frames) {
    const auto oldest = std::find_if(frames_.begin(), frames_.end(), [](const Frame& frame) {
      return frame.speed_bias.has_value();
    });
    if (oldest->is_keyframe || IsLastSight(*oldest)) {
      const std::array<BlockId, 1> gone = {*oldest->speed_bias};
      graph_.Marginalise(gone);
      oldest->speed_bias.reset();
      (oldest + 1)->imu.reset();
    } else {
      DropObservations(oldest->index);
      HoldPingsOf(oldest->index);
      const std::array<BlockId, 2> gone = {oldest->pose, *oldest->speed_bias};
      graph_.Marginalise(gone);
      (oldest + 1)->imu.reset();
      frames_.erase(oldest);
    }
  }
  while (static_cast<int>(frames_.size()) - NumRecent() > config_.keyframes) {
    MarginaliseKeyframe(frames_.front());
    frames_.pop_front();
  }
}

void SlidingWindow::MarginaliseKeyframe(const Frame& frame) {
  const std::int64_t first_recent =
      frames_[frames_.size() - static_cast<std::size_t>(NumRecent())].index;
  std::vector<BlockId> gone;
  for (auto at = points_.begin(); at != points_.end();) {
    Point& point = at->second;
    const bool seen_there =
        !point.observations.empty() && point.observations.front().frame == frame.index;
    const bool lives =
        !point.observations.empty() && point.observations.back().frame >= first_recent;
    if (seen_there && !lives && point.landmark) {
      Depart(at->first, point);
      gone.push_back(*point.landmark);
      at = points_.erase(at);
    } else {
      ++at;
    }
  }
  DropObservations(frame.index);
  HoldPingsOf(frame.index);
  gone.push_back(frame.pose);
  graph_.Marginalise(gone);
}

const SlidingWindow::Frame& SlidingWindow::FrameAt(std::int64_t index) const {
  return *std::lower_bound(frames_.begin(), frames_.end(), index,
                           [](const Frame& frame, std::int64_t at) { return frame.index < at; });
}

/// Of the frames that have a velocity; the latest always has.
const SlidingWindow::Frame& SlidingWindow::NearestMoving(Time t) const {
  const Frame* nearest = &frames_.back();
  const auto distance = [t](const Frame& frame) { return std::abs((frame.t - t).ns); };
  for (const Frame& frame : frames_)
    if (frame.speed_bias && distance(frame) < distance(*nearest)) nearest = &frame;
  return *nearest;
}

int SlidingWindow::NumRecent() const {
  return static_cast<int>(std::count_if(frames_.begin(), frames_.end(), [](const Frame& frame) {
    return frame.speed_bias.has_value();
  }));
}

NavState SlidingWindow::StateOf(const Frame& frame) const {
  const SpeedBias speed_bias = SpeedBiasFromParameters(graph_.Values(*frame.speed_bias).data());
  return {frame.t, graph_.PoseOf(frame.pose), speed_bias.v_W, speed_bias.bias.gyro,
          speed_bias.bias.accel};
}

NavState SlidingWindow::Latest() const { return StateOf(frames_.back()); }

std::optional<Eigen::Matrix<double, 6, 6>> SlidingWindow::LatestCovariance() const {
  const auto covariance = graph_.CovarianceOf(frames_.back().pose);
  if (!covariance) return std::nullopt;
  return Eigen::Matrix<double, 6, 6>(*covariance);
}

std::optional<OdometryLink> SlidingWindow::LinkToKeyframe() const {
  const Frame& now = frames_.back();
  const auto before = std::find_if(frames_.rbegin() + 1, frames_.rend(),
                                   [](const Frame& frame) { return frame.is_keyframe; });
  if (before == frames_.rend()) return std::nullopt;
  const std::array<BlockId, 2> blocks = {before->pose, now.pose};
  const auto covariance = graph_.CovarianceOf(blocks);
  if (!covariance) return std::nullopt;
  return LinkBetween(graph_.PoseOf(before->pose), graph_.PoseOf(now.pose), *covariance);
}

std::optional<Eigen::Vector3d> SlidingWindow::LandmarkPosition(LandmarkId id) const {
  const auto at = points_.find(id);
  if (at == points_.end() || !at->second.landmark) return std::nullopt;
  return PositionOf(at->second);
}

std::vector<Eigen::Vector3d> SlidingWindow::LandmarkPositions() const {
  std::vector<Eigen::Vector3d> positions;
  ForEachLandmark([&](LandmarkId, const Eigen::Vector3d& p_W) { positions.push_back(p_W); });
  return positions;
}

int SlidingWindow::LandmarksInView() const { return LandmarksSeenBy(frames_.back()); }

int SlidingWindow::LandmarksSeenBy(const Frame& frame) const {
  return static_cast<int>(std::ranges::count_if(points_, [&](const auto& entry) {
    const Point& point = entry.second;
    return point.landmark && std::ranges::any_of(point.observations, [&](const Observation& seen) {
             return seen.frame == frame.index;
           });
  }));
}

bool SlidingWindow::IsLastSight(const Frame& frame) const {
  return !SeesEnough() && LandmarksSeenBy(frame) >= config_.min_landmarks;
}

}  // namespace drydock::svin2
