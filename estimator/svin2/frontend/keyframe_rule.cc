#include "estimator/svin2/frontend/keyframe_rule.h"

#include <algorithm>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

KeyframeRule::KeyframeRule(const Config& config) : config_(config) {
  RequireInput(config.max_overlap >= 0.0 && config.max_overlap <= 1.0 &&
                   config.max_match_ratio >= 0.0 && config.max_match_ratio <= 1.0 &&
                   config.min_tracked_share >= 0.0 && config.min_tracked_share <= 1.0,
               "max_overlap is {}, max_match_ratio {} and min_tracked_share {}; all must lie in "
               "[0, 1]",
               config.max_overlap, config.max_match_ratio, config.min_tracked_share);
  RequireInput(config.min_points >= 0, "min_points is {}; it must not be negative",
               config.min_points);
  RequireInput(config.min_gap >= 1 && config.max_gap >= config.min_gap,
               "min_gap is {} and max_gap {}; they must be at least 1 and rise", config.min_gap,
               config.max_gap);
}

// With `known`, only of those points.
KeyframeRule::Seen KeyframeRule::See(const std::vector<TrackedPoint>& points, int camera,
                                     const std::set<LandmarkId>* known) {
  Seen seen;
  std::vector<cv::Point2f> pixels;
  for (const TrackedPoint& point : points) {
    const auto pixel = camera == 0 ? std::optional(point.left) : point.right;
    if (!pixel.has_value() || (known != nullptr && !known->contains(point.id))) continue;
    seen.ids.insert(point.id);
    pixels.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
  }
  if (pixels.size() >= 3) {
    std::vector<cv::Point2f> hull;
    cv::convexHull(pixels, hull);
    seen.area = cv::contourArea(hull);
  }
  return seen;
}

bool KeyframeRule::Decide(const std::vector<TrackedPoint>& points) {
  if (!has_keyframe_) return true;
  ++frames_since_;
  // A corner that is gone in the next frame was noise, and is not missed.
  if (frames_since_ == 1) Refer(points);
  if (points.empty()) return true;
  if (frames_since_ < config_.min_gap) return false;
  if (IsTooLittle(points)) return true;
  if (frames_since_ >= config_.max_gap) return true;
  const auto most = static_cast<double>(keyframe_[0].ids.size());
  if (static_cast<double>(points.size()) < config_.min_tracked_share * most) return true;
  double overlap = 0.0, ratio = 0.0;
  for (int camera = 0; camera < 2; ++camera) {
    const Seen& then = keyframe_[camera];
    const Seen shared = See(points, camera, &then.ids);
    if (then.area > 0.0) overlap = std::max(overlap, shared.area / then.area);
    if (then.ids.empty()) continue;
    ratio = std::max(ratio,
                     static_cast<double>(shared.ids.size()) / static_cast<double>(then.ids.size()));
  }
  return overlap <= config_.max_overlap || ratio <= config_.max_match_ratio;
}

bool KeyframeRule::IsTooLittle(const std::vector<TrackedPoint>& points) const {
  return points.size() < static_cast<std::size_t>(config_.min_points);
}

void KeyframeRule::Refer(const std::vector<TrackedPoint>& points) {
  for (int camera = 0; camera < 2; ++camera) keyframe_[camera] = See(points, camera, nullptr);
}

bool KeyframeRule::Keep(const std::vector<TrackedPoint>& points) {
  if (IsTooLittle(points)) return false;
  Refer(points);
  has_keyframe_ = true;
  frames_since_ = 0;
  return true;
}

}  // namespace drydock::svin2
