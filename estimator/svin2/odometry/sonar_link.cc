#include "estimator/svin2/odometry/sonar_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sensors_models/models/sonar_model.h"

namespace drydock::svin2 {
namespace {

/// Standard deviation of a range [m]. No sonar is better than a millimetre, whatever its sheet
/// says.
double RangeSigma(const SonarSheet& sheet) { return std::max(SonarRangeSigma(sheet), 1e-3); }

}  // namespace

bool SonarLink::Add(Time t, const SonarPing& ping) {
  if (!std::isfinite(ping.range) || !std::isfinite(ping.head_angle) || (last_ && t <= *last_))
    return false;
  last_ = t;
  // No echo, or one beyond what the paper's authors found to be true.
  if (ping.range >= sheet_.min_range_m && ping.range <= config_.max_range_m && ping.range > 0.0)
    waiting_.push_back({t, ping});
  return true;
}

void SonarLink::StartMap() {
  tied_.clear();
  memory_.Clear();
}

std::vector<EstimatorEvent> SonarLink::Feed(SlidingWindow& window, const ImuBuffer& imu,
                                            const NavState& before, bool is_tracking) {
  tied_.clear();
  const auto ping = SurestPing(window, imu, before);
  if (!ping) return {};
  Tie(*ping, window);
  if (!is_tracking) return {};
  const SonarRangeObservation& seen = ping->observation;
  rig_scale_.Add(seen.range, ping->patch.innovation,
                 std::hypot(seen.sigma_range, seen.sigma_patch));
  if (auto complaint = rig_scale_.Complaint()) return {{window.Latest().t, *std::move(complaint)}};
  return {};
}

std::optional<SonarLink::Met> SonarLink::SurestPing(const SlidingWindow& window,
                                                    const ImuBuffer& imu, const NavState& before) {
  const NavState now = window.Latest();
  std::optional<Met> best;
  for (; !waiting_.empty() && waiting_.front().t <= now.t; waiting_.pop_front()) {
    const auto& [t, ping] = waiting_.front();
    const auto way = imu.Integrate(before.t, t, {before.gyro_bias, before.accel_bias});
    if (!way) continue;
    const Pose T_WI = Propagate(before, *way).T_WI;
    const Pose T_WS = T_WI * sheet_.T_IS;
    const PingRay ray{T_WS.p(), T_WS.q() * SonarBeam(ping.head_angle), ping.range};
    echoes_.push_back({t, ray.head_W + ray.range * ray.direction_W});
    auto patch = PatchOf(ray, window);
    if (!patch || (best && patch->sigma >= best->patch.sigma)) continue;
    SonarRangeObservation observation;
    observation.range = ping.range + patch->range_correction;
    observation.T_frame_ping = now.T_WI.Inverse() * T_WI;
    observation.p_IS = sheet_.T_IS.p();
    observation.sigma_range = RangeSigma(sheet_);
    observation.sigma_patch = patch->sigma;
    best = Met{t, observation, *std::move(patch)};
  }
  return best;
}

std::optional<SonarPatch> SonarLink::PatchOf(const PingRay& ping,
                                             const SlidingWindow& window) const {
  const Eigen::Vector3d echo = ping.head_W + ping.range * ping.direction_W;
  const double radius = PatchRadius(ping, config_.patch);
  std::vector<PatchCandidate> candidates;
  memory_.ForEachNear(echo, radius, [&](const Eigen::Vector3d& p_W) {
    candidates.push_back({p_W, std::nullopt});
  });
  window.ForEachLandmark([&](LandmarkId id, const Eigen::Vector3d& p_W) {
    if ((p_W - echo).squaredNorm() <= radius * radius) candidates.push_back({p_W, id});
  });
  return FindSonarPatch(ping, candidates, config_.patch);
}

void SonarLink::Tie(const Met& ping, SlidingWindow& window) {
  std::vector<LandmarkId> estimated;
  std::vector<Eigen::Vector3d> departed;
  for (const PatchCandidate& member : ping.patch.members) {
    if (member.id) {
      estimated.push_back(*member.id);
    } else {
      departed.push_back(member.p_W);
    }
  }
  if (departed.empty()) tied_.push_back({ping.observation, estimated});
  window.AddSonar(ping.observation, estimated, departed);
}

}  // namespace drydock::svin2
