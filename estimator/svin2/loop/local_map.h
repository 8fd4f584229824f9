// What a keyframe and those around it know of a place.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"

namespace drydock::svin2 {

struct LocalMapConfig {
  int reach = 2;  ///< So many keyframes before and after.
  /// Where odometry from one keyframe to the next may be off by more, the local map ends [m, rad].
  double max_sigma_m = 0.03;
  double max_sigma_rad = 0.005;
};

/// The keyframe at `at` with the landmarks that those around it have besides: as if it saw them
/// too, where both its eyes would. Odometry's links lay them there. Its own points come first, so
/// that indices of these, and pings, still hold; the points as a whole are not sorted.
Keyframe LocalMapAround(const StereoGeometry& rig, const LocalMapConfig& config,
                        const std::vector<Keyframe>& keyframes, std::size_t at);

}  // namespace drydock::svin2
