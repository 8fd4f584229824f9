// Which points of two keyframes look alike (paper, "Loop-closing and Relocalization").
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/vocabulary/bag_of_words.h"

namespace drydock::svin2 {

/// A point of `now` that is taken for a point of `then`.
struct LoopMatch {
  std::size_t now = 0, then = 0;  ///< Indices into the keyframes' points.
  int distance = 0;               ///< Bits of 512 that differ.
};

/// Matches by descriptors: each is the other's nearest, and for both the nearest point of another
/// landmark is clearly further.
class LoopMatcher {
 public:
  struct Config {
    int max_distance = 100;   ///< Bits of 512 that may differ.
    double max_ratio = 0.85;  ///< Of the distances of the best and the second best.
    /// The same where a pose says in which part of the image a point must be.
    int max_distance_near = 120;
    double max_ratio_near = 0.9;
  };

  /// Throws InputError for values that cannot be used.
  explicit LoopMatcher(const Config& config);

  /// Points below the same node of the vocabulary's tree are compared, by increasing index of
  /// `now`.
  std::vector<LoopMatch> Match(const Keyframe& now, const DirectIndex& index_now,
                               const Keyframe& then, const DirectIndex& index_then) const;
  /// All points are compared with all.
  std::vector<LoopMatch> Match(const Keyframe& now, const Keyframe& then) const;
  /// Points are compared that `T_then_now` brings within `radius_px` of each other in one of the
  /// left images (of coarse points further, see ErrorScale): then's landmark in now's or, if it is
  /// no landmark, now's in then's.
  std::vector<LoopMatch> MatchNear(const StereoGeometry& rig, const Keyframe& now,
                                   const Keyframe& then, const Pose& T_then_now,
                                   double radius_px) const;

 private:
  Config config_;
};

}  // namespace drydock::svin2
