// What a keyframe and those around it know of a place.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"

namespace drydock::svin2 {

/// The keyframe at `at` with the landmarks that up to `reach` keyframes on either side, of its
/// map, have besides: as if it saw them too, where both its eyes would. Odometry, which hardly
/// drifts in between, lays them there. Its own points come first, so that indices of these, and
/// pings, still hold; the points as a whole are not sorted.
Keyframe LocalMapAround(const StereoGeometry& rig, const std::vector<Keyframe>& keyframes,
                        std::size_t at, int reach);

}  // namespace drydock::svin2
