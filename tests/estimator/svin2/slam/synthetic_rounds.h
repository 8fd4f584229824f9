// A body that swims twice round within a ring of landmarks, looking outward: its keyframes, with
// odometry that drifts.
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2::testing {

struct RoundsConfig {
  std::uint64_t seed = 1;
  int rounds = 2;
  int per_round = 40;  ///< Keyframes, two seconds apart.
  /// From the second round on each second keyframe is a glimpse.
  bool with_glimpses = false;
  /// The second round is a map of its own, laid anywhere.
  bool lost_between = false;
  /// From the second round on everything looks as before, but lies elsewhere.
  bool is_shuffled = false;
  /// A landmark has the same id in all rounds.
  bool still_tracked = false;
  /// In the second round so many keyframes in a row show what another place shows, a quarter of
  /// a round away.
  int look_alikes = 0;
};

struct Rounds {
  std::vector<Keyframe> keyframes;  ///< And glimpses.
  std::vector<Pose> truth;          ///< T_WI of each.

  bool IsRevisit(std::size_t k) const { return keyframes[k].t >= second_round; }
  Time second_round;
};

Rounds MakeRounds(const RoundsConfig& config = {});

/// Trained on the first round.
Vocabulary VocabularyOf(const Rounds& rounds);

}  // namespace drydock::svin2::testing
