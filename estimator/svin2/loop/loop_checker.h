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
    /// Up to so many pairs of points all are compared, not only those below the same node of the
    /// vocabulary: in haze noise puts a point below another.
    int max_pairs_without_index = 40'000;
    double radius_px = 10.0;        ///< About where a motion has a point.
    double guess_radius_px = 40.0;  ///< About where a guess has it: 20 cm at 3 m.
  };

  /// Throws InputError for values that cannot be used.
  LoopChecker(const Config& config, const StereoGeometry& rig);

  /// `then`, to which the index belongs, may look like `now`; `around` is what is known of its
  /// place (LocalMapAround), in which geometry looks. `T_then_now` is a guess, by odometry and what
  /// earlier loops have said of its drift. The result is good, or says why not; its inliers are
  /// points of `around`.
  Relocalisation Check(const Keyframe& now, const DirectIndex& index_now, const Keyframe& then,
                       const DirectIndex& index_then, const Keyframe& around,
                       const std::optional<Pose>& T_then_now = std::nullopt) const;
  /// All points are compared with all, for want of an index, and `then` is all that is known.
  Relocalisation Check(const Keyframe& now, const Keyframe& then,
                       const std::optional<Pose>& T_then_now = std::nullopt) const;

 private:
  Relocalisation CheckMatches(const Keyframe& now, const Keyframe& around,
                              const std::vector<LoopMatch>& matches,
                              const std::optional<Pose>& T_then_now) const;

  Config config_;
  StereoGeometry rig_;
  LoopMatcher matcher_;
  LoopVerifier seed_verifier_, verifier_;
  Relocaliser relocaliser_;
};

}  // namespace drydock::svin2
