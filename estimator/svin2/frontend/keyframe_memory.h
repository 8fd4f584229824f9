// The points of the newest keyframes, for when they come into view again.
#pragma once

#include <deque>
#include <vector>

#include "estimator/svin2/frontend/feature_track.h"

namespace drydock::svin2 {

class KeyframeMemory {
 public:
  explicit KeyframeMemory(int max_keyframes) : max_keyframes_(max_keyframes) {}

  /// Keeps the tracks of a keyframe that have a descriptor, and forgets the oldest keyframe.
  void Keep(const std::vector<FeatureTrack>& tracks);
  /// Points that are not among `live`, as the newest keyframe that has them saw them; by id.
  std::vector<FeatureTrack> Lost(const std::vector<FeatureTrack>& live) const;

 private:
  int max_keyframes_;
  std::deque<std::vector<FeatureTrack>> keyframes_;  // The newest first.
};

}  // namespace drydock::svin2
