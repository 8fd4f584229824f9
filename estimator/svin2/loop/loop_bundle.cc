#include "estimator/svin2/loop/loop_bundle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimator/svin2/factors/reprojection_factor.h"
#include "estimator/svin2/loop/fixed_pose_factor.h"
#include "estimator/svin2/loop/recognised_point_factor.h"

namespace drydock::svin2 {
namespace {

std::unique_ptr<ceres::CostFunction> SeenByFixed(const StereoGeometry& rig, int camera,
                                                 const Eigen::Vector2d& pixel, double sigma_px) {
  return std::make_unique<FixedPoseFactor>(
      std::make_unique<ReprojectionFactor>(rig.camera(camera), rig.T_IC(camera), pixel, sigma_px),
      Pose::Identity());
}

}  // namespace

LoopBundle::LoopBundle(const LoopBundleConfig& config, const StereoGeometry& rig,
                       const Keyframe& now, const Keyframe& then, const Pose& T_then_now)
    : config_(config), rig_(rig), now_(now), then_(then), pose_(graph_.AddPose(T_then_now)) {}

BlockId LoopBundle::AddLandmark(const Eigen::Vector3d& p_then) {
  ++landmarks_;
  return graph_.AddBlock({p_then.data(), 3});
}

void LoopBundle::AddPixels(std::unique_ptr<ceres::CostFunction> cost, std::vector<BlockId> blocks) {
  residuals_ += cost->num_residuals();
  const auto loss = config_.robust_pixels ? std::optional(config_.cauchy_scale) : std::nullopt;
  pixels_.push_back(graph_.AddFactor(std::move(cost), std::move(blocks), loss));
}

void LoopBundle::AddRange(std::unique_ptr<ceres::CostFunction> cost, std::vector<BlockId> blocks) {
  residuals_ += cost->num_residuals();
  ranges_.push_back(graph_.AddFactor(std::move(cost), std::move(blocks), config_.cauchy_scale));
}

void LoopBundle::AddSeenThen(BlockId landmark, const KeyframePoint& point) {
  const double share = config_.window_sigma_share;
  if (share > 0.0 && point.IsEstimated()) {
    const auto left = rig_.camera(0).Project(rig_.T_IC(0).Inverse() * *point.p_I);
    const auto right = rig_.camera(1).Project(rig_.T_IC(1).Inverse() * *point.p_I);
    if (left.has_value() && right.has_value()) {
      AddPixels(SeenByFixed(rig_, 0, *left, share * point.sigma_px), {landmark});
      AddPixels(SeenByFixed(rig_, 1, *right, share * point.sigma_px), {landmark});
      return;
    }
  }
  AddPixels(SeenByFixed(rig_, 0, point.left, point.sigma_px), {landmark});
  if (point.right.has_value())
    AddPixels(SeenByFixed(rig_, 1, *point.right, point.sigma_px), {landmark});
}

void LoopBundle::AddSeenNow(BlockId landmark, const KeyframePoint& point, double offset_px) {
  if (point.right.has_value()) {
    AddPixels(std::make_unique<RecognisedPointFactor>(rig_, point.left, *point.right,
                                                      point.sigma_px, offset_px),
              {pose_, landmark});
  } else {
    AddPixels(std::make_unique<ReprojectionFactor>(rig_.camera(0), rig_.T_IC(0), point.left,
                                                   std::hypot(point.sigma_px, offset_px)),
              {pose_, landmark});
  }
}

void LoopBundle::Add(const LoopMatch& match, const Eigen::Vector3d& p_then) {
  const BlockId landmark = AddLandmark(p_then);
  const KeyframePoint& seen = now_.points[match.now];
  AddSeenThen(landmark, then_.points[match.then]);
  AddSeenNow(landmark, seen, config_.offset_per_sigma * seen.sigma_px);
  matched_.push_back(landmark);
  of_now_.emplace(match.now, landmark);
  of_then_.emplace(match.then, landmark);
}

BlockId LoopBundle::AddMember(const Keyframe& keyframe, bool is_now, std::size_t point) {
  const KeyframePoint& seen = keyframe.points[point];
  const BlockId landmark = AddLandmark(is_now ? Motion() * *seen.p_I : *seen.p_I);
  if (is_now) {
    AddSeenNow(landmark, seen, 0.0);
  } else {
    AddSeenThen(landmark, seen);
  }
  return landmark;
}

void LoopBundle::AddRangesOf(const Keyframe& keyframe, bool is_now, ByPoint& by_point) {
  const auto is_known = [&](std::size_t point) { return by_point.contains(point); };
  // What has no depth but by the range itself would only swallow it.
  const auto can_be_added = [&](std::size_t point) {
    return is_known(point) ||
           (keyframe.points[point].IsEstimated() && keyframe.points[point].right.has_value());
  };
  for (const KeyframePing& ping : keyframe.pings) {
    if (std::ranges::none_of(ping.points, is_known) ||
        !std::ranges::all_of(ping.points, can_be_added)) {
      continue;
    }
    std::vector<BlockId> blocks;
    if (is_now) blocks.push_back(pose_);
    for (const std::size_t point : ping.points) {
      if (!is_known(point)) by_point.emplace(point, AddMember(keyframe, is_now, point));
      blocks.push_back(by_point.at(point));
    }
    auto factor = std::make_unique<SonarRangeFactor>(ping.observation, ping.points.size());
    if (is_now) {
      AddRange(std::move(factor), std::move(blocks));
    } else {
      AddRange(std::make_unique<FixedPoseFactor>(std::move(factor), Pose::Identity()),
               std::move(blocks));
    }
  }
}

void LoopBundle::AddRanges() {
  AddRangesOf(then_, false, of_then_);
  AddRangesOf(now_, true, of_now_);
}

Eigen::Vector3d LoopBundle::Landmark(std::size_t k) const {
  return Eigen::Map<const Eigen::Vector3d>(graph_.Values(matched_[k]).data());
}

double LoopBundle::LandmarkChi2(std::size_t k) const {
  double chi2 = 0.0;
  for (const FactorId factor : graph_.FactorsOf(matched_[k]))
    if (std::ranges::binary_search(pixels_, factor)) chi2 += graph_.ChiSquare(factor);
  return chi2;
}

double LoopBundle::Chi2() const {
  double chi2 = 0.0;
  for (const FactorId factor : pixels_) chi2 += graph_.ChiSquare(factor);
  for (const FactorId factor : ranges_) chi2 += graph_.ChiSquare(factor);
  return chi2;
}

}  // namespace drydock::svin2
