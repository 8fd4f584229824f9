#include "estimator/svin2/odometry/describe_keyframe.h"

#include <map>

namespace drydock::svin2 {

Keyframe DescribeKeyframe(const SlidingWindow& window, const TrackedFrame& seen,
                          const std::vector<TiedPing>& pings) {
  Keyframe keyframe;
  const NavState state = window.Latest();
  const Pose T_IW = state.T_WI.Inverse();
  keyframe.t = state.t;
  keyframe.T_WI = state.T_WI;
  keyframe.link = window.LinkToKeyframe();
  keyframe.covariance = window.LatestCovariance();
  // Kept for the whole dive: without what a growing vector holds in reserve.
  keyframe.points.reserve(seen.points.size() + seen.unfollowed.size());
  std::map<LandmarkId, std::size_t> places;
  for (const TrackedPoint& tracked : seen.points) {
    if (!tracked.descriptor) continue;
    KeyframePoint point{tracked.id, tracked.left, tracked.right, tracked.sigma_px,
                        *tracked.descriptor};
    if (const auto p_W = window.LandmarkPosition(tracked.id)) point.p_I = T_IW * *p_W;
    places.emplace(tracked.id, keyframe.points.size());
    keyframe.points.push_back(point);
  }
  for (const TrackedPoint& seen_only : seen.unfollowed) {
    keyframe.points.push_back(
        {seen_only.id, seen_only.left, seen_only.right, seen_only.sigma_px, *seen_only.descriptor});
  }
  for (const TiedPing& tied : pings) {
    KeyframePing ping{tied.observation, {}};
    for (const LandmarkId id : tied.estimated)
      if (const auto at = places.find(id); at != places.end()) ping.points.push_back(at->second);
    if (ping.points.size() == tied.estimated.size()) keyframe.pings.push_back(std::move(ping));
  }
  return keyframe;
}

}  // namespace drydock::svin2
