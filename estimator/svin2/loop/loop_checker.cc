#include "estimator/svin2/loop/loop_checker.h"

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

/// A seed only says where to look: what is found there decides.
LoopVerifier::Config ForSeed(LoopVerifier::Config config, int min_inliers) {
  config.min_inliers = min_inliers;
  config.min_inlier_share = 0.0;
  config.min_spread_px = 0.0;
  return config;
}

Relocalisation Refused(const VerifiedLoop& loop) {
  Relocalisation result;
  result.status = loop.status;
  result.T_then_now = loop.T_then_now;
  result.inliers = loop.inliers;
  return result;
}

}  // namespace

LoopChecker::LoopChecker(const Config& config, const StereoGeometry& rig)
    : config_(config),
      rig_(rig),
      matcher_(config.matcher),
      seed_verifier_(ForSeed(config.verifier, config.min_seed_inliers), rig),
      verifier_(config.verifier, rig),
      relocaliser_(config.relocaliser, rig) {
  RequireInput(config.radius_px > 0.0 && config.guess_radius_px > 0.0,
               "radius_px is {} and guess_radius_px {}; both must be positive", config.radius_px,
               config.guess_radius_px);
  RequireInput(config.max_pairs_without_index >= 0,
               "max_pairs_without_index is {}; it must not be negative",
               config.max_pairs_without_index);
}

Relocalisation LoopChecker::Check(const Keyframe& now, const DirectIndex& index_now,
                                  const Keyframe& then, const DirectIndex& index_then,
                                  const Keyframe& around,
                                  const std::optional<Pose>& T_then_now) const {
  const std::size_t pairs = now.points.size() * then.points.size();
  const auto matches = pairs <= static_cast<std::size_t>(config_.max_pairs_without_index)
                           ? matcher_.Match(now, then)
                           : matcher_.Match(now, index_now, then, index_then);
  return CheckMatches(now, around, matches, T_then_now);
}

Relocalisation LoopChecker::Check(const Keyframe& now, const Keyframe& then,
                                  const std::optional<Pose>& T_then_now) const {
  return CheckMatches(now, then, matcher_.Match(now, then), T_then_now);
}

Relocalisation LoopChecker::CheckMatches(const Keyframe& now, const Keyframe& around,
                                         const std::vector<LoopMatch>& matches,
                                         const std::optional<Pose>& T_then_now) const {
  const auto near = [&](const Pose& motion, double radius_px) {
    return matcher_.MatchNear(rig_, now, around, motion, radius_px);
  };
  VerifiedLoop loop = seed_verifier_.Verify(now, around, matches, T_then_now);
  if (!loop.IsGood() && T_then_now.has_value()) {
    loop =
        seed_verifier_.Verify(now, around, near(*T_then_now, config_.guess_radius_px), T_then_now);
  }
  if (!loop.IsGood()) return Refused(loop);
  const Pose seed = loop.T_then_now;
  loop = verifier_.Verify(now, around, near(seed, config_.radius_px), seed);
  if (!loop.IsGood()) return Refused(loop);
  return relocaliser_.Relocalise(now, around, loop.inliers, loop.T_then_now);
}

}  // namespace drydock::svin2
