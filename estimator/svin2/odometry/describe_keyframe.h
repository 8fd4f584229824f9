// A keyframe of the window, as loop closing will remember it.
#pragma once

#include <vector>

#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/window/sliding_window.h"

namespace drydock::svin2 {

/// A ping that was tied to a frame, and the landmarks of its patch.
struct TiedPing {
  SonarRangeObservation observation;
  std::vector<LandmarkId> estimated;
};

/// The window's latest frame, which saw `seen`, with the points that have a descriptor. Index and
/// map id are left to the caller.
Keyframe DescribeKeyframe(const SlidingWindow& window, const TrackedFrame& seen,
                          const std::vector<TiedPing>& pings);

}  // namespace drydock::svin2
