#include "estimator/svin2/frontend/anchor_tracker.h"

#include <Eigen/LU>
#include <cmath>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// Small images have fewer levels.
bool HasOctave(const ImagePyramid& image, const FeatureTrack& track) {
  return track.octave < static_cast<int>(image.size());
}

}  // namespace

AnchorTracker::AnchorTracker(const Config& config) : config_(config) {
  RequireInput(config.patch_radius_px >= 2 && config.patch_radius_px <= 50,
               "patch_radius_px is {}; it must lie in [2, 50]", config.patch_radius_px);
  RequireInput(config.max_scale > 1.0, "max_scale is {}; it must be above 1", config.max_scale);
}

bool AnchorTracker::Anchor(const ImagePyramid& image, FeatureTrack& track) const {
  if (!HasOctave(image, track)) return false;
  auto patch = PatchTemplate::Make(image[track.octave], track.left / OctaveScale(track.octave),
                                   config_.patch_radius_px);
  if (!patch.has_value()) return false;
  track.anchor = std::make_shared<const PatchTemplate>(std::move(*patch));
  track.warp.setIdentity();
  return true;
}

std::optional<PatchAlignment> AnchorTracker::Align(const ImagePyramid& image,
                                                   const Eigen::Vector2d& start,
                                                   double max_align_px,
                                                   const FeatureTrack& track) const {
  if (!HasOctave(image, track)) return std::nullopt;
  const double scale = OctaveScale(track.octave);
  auto found = track.anchor->Align(image[track.octave], start / scale, track.warp, config_.affine);
  if (!found.has_value() || found->correlation < config_.min_correlation) return std::nullopt;
  found->pixel *= scale;
  if ((found->pixel - start).norm() > scale * max_align_px) return std::nullopt;
  return found;
}

bool AnchorTracker::Update(const ImagePyramid& now, const Eigen::Vector2d& start,
                           double max_align_px, FeatureTrack& track) const {
  const auto found = Align(now, start, max_align_px, track);
  if (!found.has_value()) return false;
  const double scale = std::sqrt(found->warp.determinant());
  if (scale > config_.max_scale || scale < 1.0 / config_.max_scale) return false;
  track.left = found->pixel;
  track.warp = found->warp;
  track.correlation = found->correlation;
  return true;
}

std::optional<Eigen::Vector2d> AnchorTracker::FindInRight(const ImagePyramid& right,
                                                          const Eigen::Vector2d& start,
                                                          const FeatureTrack& track) const {
  const auto found = Align(right, start, config_.max_align_px, track);
  return found.has_value() ? std::optional(found->pixel) : std::nullopt;
}

bool AnchorTracker::Follow(const ImagePyramid& before, const ImagePyramid& now,
                           const Eigen::Vector2d& start, FeatureTrack& track) const {
  if (Update(now, start, config_.max_align_px, track)) return true;
  if (track.renewals >= config_.max_renewals) return false;
  ++track.renewals;
  return Anchor(before, track) && Update(now, start, config_.max_align_px, track);
}

bool AnchorTracker::Regain(const ImagePyramid& now, const Eigen::Vector2d& start,
                           FeatureTrack& track) const {
  return Update(now, start, 2.0 * config_.max_align_px, track);
}

}  // namespace drydock::svin2
