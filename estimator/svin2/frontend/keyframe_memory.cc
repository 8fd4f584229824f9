#include "estimator/svin2/frontend/keyframe_memory.h"

#include <map>
#include <set>

namespace drydock::svin2 {

void KeyframeMemory::Keep(const std::vector<FeatureTrack>& tracks) {
  if (max_keyframes_ <= 0) return;
  std::vector<FeatureTrack>& kept = keyframes_.emplace_front();
  for (const FeatureTrack& track : tracks) {
    if (track.descriptor.has_value()) kept.push_back(track);
  }
  if (keyframes_.size() > static_cast<std::size_t>(max_keyframes_)) keyframes_.pop_back();
}

std::vector<FeatureTrack> KeyframeMemory::Lost(const std::vector<FeatureTrack>& live) const {
  std::set<LandmarkId> known;
  for (const FeatureTrack& track : live) known.insert(track.id);
  std::map<LandmarkId, const FeatureTrack*> lost;
  for (const auto& keyframe : keyframes_) {
    for (const FeatureTrack& track : keyframe) {
      if (!known.contains(track.id)) lost.try_emplace(track.id, &track);
    }
  }
  std::vector<FeatureTrack> result;
  result.reserve(lost.size());
  for (const auto& [id, track] : lost) result.push_back(*track);
  return result;
}

}  // namespace drydock::svin2
