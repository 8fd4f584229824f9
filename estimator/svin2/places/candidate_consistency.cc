#include "estimator/svin2/places/candidate_consistency.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

CandidateConsistency::CandidateConsistency(const Config& config) : config_(config) {
  RequireInput(config.max_gap >= 1 && config.required >= 1,
               "max_gap is {} and required {}; both must be at least 1", config.max_gap,
               config.required);
}

std::vector<CandidateConsistency::Island> CandidateConsistency::IslandsOf(
    std::vector<PlaceMatch> candidates) const {
  std::ranges::sort(candidates, {}, &PlaceMatch::keyframe);
  std::vector<Island> islands;
  for (const PlaceMatch& match : candidates) {
    if (islands.empty() || match.keyframe - islands.back().last > config_.max_gap) {
      islands.push_back({match.keyframe, match.keyframe, match, 1});
      continue;
    }
    Island& island = islands.back();
    island.last = match.keyframe;
    if (match.score > island.best.score) island.best = match;
  }
  return islands;
}

std::vector<PlaceMatch> CandidateConsistency::Update(std::vector<PlaceMatch> candidates) {
  std::vector<Island> islands = IslandsOf(std::move(candidates));
  std::vector<PlaceMatch> consistent;
  for (Island& island : islands) {
    for (const Island& before : islands_) {
      const bool is_near = island.first - before.last <= config_.max_gap &&
                           before.first - island.last <= config_.max_gap;
      if (is_near) island.times = std::max(island.times, before.times + 1);
    }
    if (island.times >= config_.required) consistent.push_back(island.best);
  }
  islands_ = std::move(islands);
  std::ranges::stable_sort(consistent, std::ranges::greater{}, &PlaceMatch::score);
  return consistent;
}

}  // namespace drydock::svin2
