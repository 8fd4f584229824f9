#include "estimator/svin2/loop/loop_checker.h"

#include <algorithm>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

/// Fewer are asked for, never more.
template <typename Config>
Config WithInliers(Config config, int min_inliers) {
  config.min_inliers = std::min(config.min_inliers, min_inliers);
  return config;
}

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
      judge_{LoopVerifier(config.verifier, rig), Relocaliser(config.relocaliser, rig)},
      judge_of_guessed_{
          LoopVerifier(WithInliers(config.verifier, config.min_guessed_inliers), rig),
          Relocaliser(WithInliers(config.relocaliser, config.min_guessed_inliers), rig)} {
  RequireInput(config.radius_px > 0.0 && config.guess_radius_px > 0.0,
               "radius_px is {} and guess_radius_px {}; both must be positive", config.radius_px,
               config.guess_radius_px);
  RequireInput(config.max_pairs_without_index >= 0,
               "max_pairs_without_index is {}; it must not be negative",
               config.max_pairs_without_index);
}

Relocalisation LoopChecker::Check(const Keyframe& now, const DirectIndex& index_now,
                                  const Keyframe& then, const DirectIndex& index_then,
                                  const std::optional<Pose>& T_then_now) const {
  const std::size_t pairs = now.points.size() * then.points.size();
  if (pairs <= static_cast<std::size_t>(config_.max_pairs_without_index))
    return Check(now, then, T_then_now);
  return Check(now, then, matcher_.Match(now, index_now, then, index_then), T_then_now);
}

Relocalisation LoopChecker::Check(const Keyframe& now, const Keyframe& then,
                                  const std::optional<Pose>& T_then_now) const {
  return Check(now, then, matcher_.Match(now, then), T_then_now);
}

Relocalisation LoopChecker::Check(const Keyframe& now, const Keyframe& then,
                                  const std::vector<LoopMatch>& matches,
                                  const std::optional<Pose>& T_then_now) const {
  VerifiedLoop loop = seed_verifier_.Verify(now, then, matches, T_then_now);
  if (!loop.IsGood() && T_then_now.has_value()) {
    const auto near = matcher_.MatchNear(rig_, now, then, *T_then_now, config_.guess_radius_px);
    loop = seed_verifier_.Verify(now, then, near, T_then_now);
  }
  if (!loop.IsGood()) return Refused(loop);
  const Pose seed = loop.T_then_now;
  const Judge& judge = JudgeOf(seed, T_then_now);
  loop = judge.verifier.Verify(now, then,
                               matcher_.MatchNear(rig_, now, then, seed, config_.radius_px), seed);
  if (!loop.IsGood()) return Refused(loop);
  return judge.relocaliser.Relocalise(now, then, loop.inliers, loop.T_then_now);
}

const LoopChecker::Judge& LoopChecker::JudgeOf(const Pose& T_then_now,
                                               const std::optional<Pose>& guess) const {
  if (!guess.has_value()) return judge_;
  const bool foretold =
      (T_then_now.p() - guess->p()).norm() < config_.max_guess_error_m &&
      LogSO3(T_then_now.q() * guess->q().conjugate()).norm() < config_.max_guess_error_rad;
  return foretold ? judge_of_guessed_ : judge_;
}

}  // namespace drydock::svin2
