#include "estimator/svin2/loop/local_map.h"

#include <optional>
#include <unordered_set>

#include "estimator/svin2/loop/keyframe_landmarks.h"

namespace drydock::svin2 {
namespace {

double Square(double x) { return x * x; }

class LocalMap {
 public:
  LocalMap(const StereoGeometry& rig, const Keyframe& centre) : rig_(rig), map_(centre) {
    for (const KeyframePoint& point : centre.points) known_.insert(point.id);
  }

  void Add(const Keyframe& neighbour, const Pose& T_centre_neighbour) {
    for (const KeyframePoint& point : neighbour.points) {
      if (!point.p_I.has_value()) continue;
      const auto moved = Moved(point, T_centre_neighbour * *point.p_I);
      if (moved.has_value() && known_.insert(point.id).second) map_.points.push_back(*moved);
    }
  }

  Keyframe Take() { return std::move(map_); }

 private:
  std::optional<KeyframePoint> Moved(KeyframePoint point, const Eigen::Vector3d& p_I) const {
    const auto left = PixelInLeft(rig_, p_I);
    const auto right = rig_.camera(1).Project(rig_.T_IC(1).Inverse() * p_I);
    if (!left.has_value() || !right.has_value()) return std::nullopt;
    point.left = *left;
    point.right = right;
    point.p_I = p_I;
    return point;
  }

  const StereoGeometry& rig_;
  Keyframe map_;
  std::unordered_set<LandmarkId> known_;  // Asked only, never gone through.
};

bool IsSure(const LocalMapConfig& config, const std::optional<OdometryLink>& link) {
  return link.has_value() &&
         link->covariance.topLeftCorner<3, 3>().trace() <= Square(config.max_sigma_m) &&
         link->covariance.bottomRightCorner<3, 3>().trace() <= Square(config.max_sigma_rad);
}

/// Goes from keyframe to keyframe as long as odometry is sure of the way.
class Walk {
 public:
  Walk(const LocalMapConfig& config, const std::vector<Keyframe>& keyframes, std::size_t at)
      : config_(config), keyframes_(keyframes), at_(at) {}

  bool Forward() {
    if (at_ + 1 == keyframes_.size() || !IsSure(config_, keyframes_[at_ + 1].link)) return false;
    T_start_at_ = T_start_at_ * keyframes_[++at_].link->T_before_now;
    return true;
  }
  bool Back() {
    if (at_ == 0 || !IsSure(config_, keyframes_[at_].link)) return false;
    T_start_at_ = T_start_at_ * keyframes_[at_--].link->T_before_now.Inverse();
    return true;
  }
  void AddTo(LocalMap& map) const { map.Add(keyframes_[at_], T_start_at_); }

 private:
  const LocalMapConfig& config_;
  const std::vector<Keyframe>& keyframes_;
  std::size_t at_;
  Pose T_start_at_;
};

}  // namespace

Keyframe LocalMapAround(const StereoGeometry& rig, const LocalMapConfig& config,
                        const std::vector<Keyframe>& keyframes, std::size_t at) {
  LocalMap map(rig, keyframes[at]);
  Walk before(config, keyframes, at), after(config, keyframes, at);
  bool goes_back = true, goes_on = true;
  // The nearest first: of a landmark that several have, theirs counts.
  for (int step = 0; step < config.reach; ++step) {
    goes_back = goes_back && before.Back();
    if (goes_back) before.AddTo(map);
    goes_on = goes_on && after.Forward();
    if (goes_on) after.AddTo(map);
  }
  return map.Take();
}

}  // namespace drydock::svin2
