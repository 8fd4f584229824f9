// The truth at the instants of which an estimator speaks.
#pragma once

#include "sensors_models/base/time.h"
#include "sensors_models/base/trajectory.h"

namespace drydock {

/// Neighbours in the truth between which it is known well enough: a body that accelerates by
/// 0.5 m/s^2 strays from their chord by 0.2 mm at most [ns].
inline constexpr Duration kDenseTruth{50'000'000};

/// `truth` and its own interpolation at the stamps of `estimate`, wherever the two neighbours of a
/// stamp are at most `max_gap` apart. A recording has the truth at stamps of its own; the nearest
/// one, up to 5 ms away at 100 Hz, would charge a body at 0.5 m/s with 2.5 mm that are not the
/// estimator's.
Trajectory AddInterpolated(const Trajectory& truth, const Trajectory& estimate,
                           Duration max_gap = kDenseTruth);

}  // namespace drydock
