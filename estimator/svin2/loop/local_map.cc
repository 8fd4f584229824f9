#include "estimator/svin2/loop/local_map.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "estimator/svin2/loop/keyframe_landmarks.h"

namespace drydock::svin2 {
namespace {

class LocalMap {
 public:
  LocalMap(const StereoGeometry& rig, const Keyframe& centre) : rig_(rig), map_(centre) {
    for (const KeyframePoint& point : centre.points) known_.insert(point.id);
  }

  void Add(const Keyframe& neighbour) {
    const Pose T_centre_neighbour = map_.T_WI.Inverse() * neighbour.T_WI;
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

}  // namespace

Keyframe LocalMapAround(const StereoGeometry& rig, const std::vector<Keyframe>& keyframes,
                        std::size_t at, int reach) {
  LocalMap map(rig, keyframes[at]);
  const auto add = [&](std::size_t k) {
    if (keyframes[k].map_id == keyframes[at].map_id) map.Add(keyframes[k]);
  };
  // The nearest first: of a landmark that several have, theirs counts.
  for (std::size_t step = 1; step <= static_cast<std::size_t>(std::max(0, reach)); ++step) {
    if (step <= at) add(at - step);
    if (at + step < keyframes.size()) add(at + step);
  }
  return map.Take();
}

}  // namespace drydock::svin2
