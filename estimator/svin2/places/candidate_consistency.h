// Places that are proposed time and again.
#pragma once

#include <vector>

#include "estimator/svin2/places/place_database.h"

namespace drydock::svin2 {

/// Lets a loop candidate pass if the keyframes just before have proposed the same place. Candidates
/// that follow one another closely make an island, one place (Galvez-Lopez and Tardos 2012); an
/// island continues one of the keyframe before if the two lie as close.
class CandidateConsistency {
 public:
  struct Config {
    int max_gap = 3;   ///< Keyframes between neighbours of an island, and between islands.
    int required = 3;  ///< Keyframes in a row that must propose a place, the latest included.
  };

  /// Throws InputError for values that cannot be used.
  explicit CandidateConsistency(const Config& config);

  /// Of the keyframe at hand, in any order; call it for each, also without candidates. The best
  /// candidate of each island that has been proposed often enough, the best first.
  std::vector<PlaceMatch> Update(std::vector<PlaceMatch> candidates);

  void Restart() { islands_.clear(); }

 private:
  struct Island {
    KeyframeIndex first = 0, last = 0;
    PlaceMatch best;
    int times = 1;  // Keyframes in a row that proposed it.
  };

  std::vector<Island> IslandsOf(std::vector<PlaceMatch> candidates) const;

  Config config_;
  std::vector<Island> islands_;  // Of the keyframe before.
};

}  // namespace drydock::svin2
