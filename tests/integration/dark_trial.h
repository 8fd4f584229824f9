// SVIn2 blinded for a while on a dive that comes back to a place known from before.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "estimator/interface/estimator.h"
#include "scenarios/scoring/loops.h"
#include "tests/integration/recorded_dive.h"

namespace drydock::testing {

/// The estimator's loops, by the truth.
score::LoopScore ScoreLoops(const RecordedDive& dive, const Estimator& estimator);

/// How it came back.
struct DarkTrial {
  /// From the light's return to the first frame whose place was recognised, and to the first
  /// estimate that was published with that correction; nothing: never.
  std::optional<double> recognised_s, corrected_s;
  /// Position error of the last published estimate, corrected as it was then (T_GW), where the
  /// odometry before the dark is laid upon the truth by position and yaw.
  double live_error_m = 0.0;
  /// ATE in the end, without the dark and the wait for the first loop, as a share of the path.
  double ate_percent = 0.0, ate_odometry_percent = 0.0;
  int maps = 1;  ///< More than one: tracking was lost for good.
  std::size_t loops = 0, true_loops = 0;
};

/// `svin2` from its own start, with black images from `dark` to `light`.
DarkTrial RunInTheDark(const RecordedDive& dive, Time dark, Time light);

/// One line.
std::string Line(const DarkTrial& trial);

}  // namespace drydock::testing
