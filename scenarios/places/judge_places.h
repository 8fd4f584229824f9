// How well a vocabulary tells places apart.
#pragma once

#include <vector>

#include "estimator/svin2/places/candidate_consistency.h"
#include "estimator/svin2/places/place_database.h"
#include "estimator/svin2/vocabulary/vocabulary.h"
#include "scenarios/places/keyframe_views.h"

namespace drydock {

struct PlaceJudging {
  double min_gap_s = 10.0;  ///< Keyframes nearer in time are of the same passage and do not count.
  /// Two keyframes show the same place if they are as near as this [m, rad],
  double same_distance_m = 1.0;
  double same_angle_rad = 0.35;
  /// and different ones if they are further apart than one of these; what is between does not
  /// count.
  double other_distance_m = 3.0;
  double other_angle_rad = 1.0;
  int neighbours = 2;  ///< Keyframes just before the one at hand, for the rule's bound.
  svin2::LoopCandidateRule rule;
  svin2::CandidateConsistency::Config consistency;
};

/// How many of the candidates are of the same place, and of another.
struct CandidateCount {
  int same = 0, other = 0, between = 0;
};

struct PlaceJudgement {
  std::vector<double> same, other;  ///< Scores of the pairs of keyframes, rising.
  std::vector<double> neighbours;   ///< Scores of each keyframe with the one before it, rising.
  int revisits = 0;                 ///< Keyframes of which an earlier one shows the same place.
  CandidateCount best;              ///< The best candidate of each keyframe by the rule.
  CandidateCount consistent;        ///< The best that also passes the temporal filter.
};

/// Goes through the keyframes of one dive as loop closing does.
PlaceJudgement JudgePlaces(const svin2::Vocabulary& vocabulary,
                           const std::vector<KeyframeView>& views, const PlaceJudging& judging);

}  // namespace drydock
