#include "estimator/svin2/loop/loop_matcher.h"

#include <algorithm>

#include "estimator/svin2/loop/keyframe_landmarks.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

constexpr int kFar = 513;

// One landmark may have been followed twice, under two ids: then it is seen in one spot.
bool AreOne(const KeyframePoint& a, const KeyframePoint& b) {
  constexpr double kSpotPx = 3.0;
  return a.id == b.id ||
         (a.left - b.left).norm() <= kSpotPx * std::max(ErrorScale(a), ErrorScale(b));
}

// The nearest of the points that one point was compared with.
struct Nearest {
  std::size_t at = 0;
  const KeyframePoint* point = nullptr;
  int distance = kFar;
  int other = kFar;  // Of the nearest point of another landmark.

  void Offer(std::size_t candidate, const KeyframePoint& landmark, int bits) {
    if (bits >= other) return;
    const bool is_other = point != nullptr && !AreOne(landmark, *point);
    if (bits < distance) {
      if (is_other) other = distance;
      at = candidate;
      point = &landmark;
      distance = bits;
    } else if (is_other) {
      other = bits;
    }
  }
  bool IsClear(int max_distance, double max_ratio) const {
    return distance <= max_distance && distance <= max_ratio * other;
  }
};

// Takes pairs in any order, then tells which are each other's nearest.
class MutualNearest {
 public:
  MutualNearest(const Keyframe& now, const Keyframe& then)
      : now_(now), then_(then), of_now_(now.points.size()), of_then_(then.points.size()) {}

  void Compare(std::size_t i, std::size_t j) {
    const KeyframePoint& a = now_.points[i];
    const KeyframePoint& b = then_.points[j];
    const int bits = HammingDistance(a.descriptor, b.descriptor);
    of_now_[i].Offer(j, b, bits);
    of_then_[j].Offer(i, a, bits);
  }

  std::vector<LoopMatch> Matches(int max_distance, double max_ratio) const {
    std::vector<LoopMatch> matches;
    for (std::size_t i = 0; i < of_now_.size(); ++i) {
      const Nearest& nearest = of_now_[i];
      if (!nearest.IsClear(max_distance, max_ratio)) continue;
      const Nearest& back = of_then_[nearest.at];
      if (back.at != i || !back.IsClear(max_distance, max_ratio)) continue;
      matches.push_back({i, nearest.at, nearest.distance});
    }
    return matches;
  }

 private:
  const Keyframe& now_;
  const Keyframe& then_;
  std::vector<Nearest> of_now_, of_then_;
};

std::vector<std::optional<Eigen::Vector2d>> Pixels(const StereoGeometry& rig,
                                                   const Keyframe& keyframe, const Pose& T) {
  std::vector<std::optional<Eigen::Vector2d>> pixels;
  pixels.reserve(keyframe.points.size());
  for (const KeyframePoint& point : keyframe.points)
    pixels.push_back(point.p_I.has_value() ? PixelInLeft(rig, T * *point.p_I) : std::nullopt);
  return pixels;
}

}  // namespace

LoopMatcher::LoopMatcher(const Config& config) : config_(config) {
  for (const int bits : {config.max_distance, config.max_distance_near}) {
    RequireInput(bits >= 0 && bits <= 512,
                 "a descriptor's largest distance is {}; it must lie in [0, 512]", bits);
  }
  for (const double ratio : {config.max_ratio, config.max_ratio_near}) {
    RequireInput(ratio > 0.0 && ratio <= 1.0,
                 "a ratio of descriptors' distances is {}; it must lie in (0, 1]", ratio);
  }
}

std::vector<LoopMatch> LoopMatcher::Match(const Keyframe& now, const DirectIndex& index_now,
                                          const Keyframe& then,
                                          const DirectIndex& index_then) const {
  MutualNearest nearest(now, then);
  for (const NodeMembers& members : index_now) {
    const auto found = std::ranges::lower_bound(index_then, members.node, {}, &NodeMembers::node);
    if (found == index_then.end() || found->node != members.node) continue;
    for (const std::size_t i : members.descriptors)
      for (const std::size_t j : found->descriptors) nearest.Compare(i, j);
  }
  return nearest.Matches(config_.max_distance, config_.max_ratio);
}

std::vector<LoopMatch> LoopMatcher::Match(const Keyframe& now, const Keyframe& then) const {
  MutualNearest nearest(now, then);
  for (std::size_t i = 0; i < now.points.size(); ++i)
    for (std::size_t j = 0; j < then.points.size(); ++j) nearest.Compare(i, j);
  return nearest.Matches(config_.max_distance, config_.max_ratio);
}

std::vector<LoopMatch> LoopMatcher::MatchNear(const StereoGeometry& rig, const Keyframe& now,
                                              const Keyframe& then, const Pose& T_then_now,
                                              double radius_px) const {
  const auto then_in_now = Pixels(rig, then, T_then_now.Inverse());
  const auto now_in_then = Pixels(rig, now, T_then_now);
  const auto is_near = [radius_px](const std::optional<Eigen::Vector2d>& expected,
                                   const KeyframePoint& seen) {
    return expected.has_value() && (*expected - seen.left).norm() <= radius_px * ErrorScale(seen);
  };
  MutualNearest nearest(now, then);
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    for (std::size_t j = 0; j < then.points.size(); ++j) {
      if (then.points[j].p_I.has_value() ? is_near(then_in_now[j], now.points[i])
                                         : is_near(now_in_then[i], then.points[j])) {
        nearest.Compare(i, j);
      }
    }
  }
  return nearest.Matches(config_.max_distance_near, config_.max_ratio_near);
}

}  // namespace drydock::svin2
