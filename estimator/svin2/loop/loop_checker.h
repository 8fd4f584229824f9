// From two keyframes that may show one place to the motion between them.
#pragma once

#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/loop/loop_matcher.h"
#include "estimator/svin2/loop/loop_verifier.h"
#include "estimator/svin2/loop/relocaliser.h"

namespace drydock::svin2 {

/// Puts matcher, verifier and relocaliser together. A few matches by looks alone give a motion;
/// with it points are looked for where they must be, which finds two to three times as many, and
/// these decide. Where looks alone do not reach, a guess of the motion takes their place.
class LoopChecker {
 public:
  struct Config {
    LoopMatcher::Config matcher = {};
    LoopVerifier::Config verifier = {};
    Relocaliser::Config relocaliser = {};
    int min_seed_inliers = 10;  ///< Of the matches by looks alone.
    /// Of a motion that a guess foretold, fewer inliers convince than verifier and relocaliser ask
    /// for: it agrees with odometry as well.
    int min_guessed_inliers = 10;
    double max_guess_error_m = 0.5;  ///< So near it was foretold,
    double max_guess_error_rad = 0.1;
    /// Up to so many pairs of points all are compared, not only those below the same node of the
    /// vocabulary: in haze noise puts a point below another.
    int max_pairs_without_index = 40'000;
    double radius_px = 10.0;        ///< About where a motion has a point.
    double guess_radius_px = 40.0;  ///< About where a guess has it: 20 cm at 3 m.
  };

  /// Throws InputError for values that cannot be used.
  LoopChecker(const Config& config, const StereoGeometry& rig);

  /// `T_then_now` is a guess, by odometry and what earlier loops have said of its drift. The result
  /// is good, or says why not.
  Relocalisation Check(const Keyframe& now, const DirectIndex& index_now, const Keyframe& then,
                       const DirectIndex& index_then,
                       const std::optional<Pose>& T_then_now = std::nullopt) const;
  /// All points are compared with all, for want of an index.
  Relocalisation Check(const Keyframe& now, const Keyframe& then,
                       const std::optional<Pose>& T_then_now = std::nullopt) const;

 private:
  Relocalisation Check(const Keyframe& now, const Keyframe& then,
                       const std::vector<LoopMatch>& matches,
                       const std::optional<Pose>& T_then_now) const;

  /// Decides on points that lie where the motion has them.
  struct Judge {
    LoopVerifier verifier;
    Relocaliser relocaliser;
  };
  const Judge& JudgeOf(const Pose& T_then_now, const std::optional<Pose>& guess) const;

  Config config_;
  StereoGeometry rig_;
  LoopMatcher matcher_;
  LoopVerifier seed_verifier_;
  Judge judge_, judge_of_guessed_;
};

}  // namespace drydock::svin2
