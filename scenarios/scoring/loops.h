// Were the places that an estimator recognised truly the same, and how many did it miss?
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// A place that an estimator says it was at twice.
struct Loop {
  Time t_now;
  Time t_then;
  Pose T_then_now;  ///< Maps points of the body now into the body then.
};

/// Whether a loop is within 0.25 m plus 5 % of the true distance, and within 5 degrees, of the true
/// pose of the body now in the body then. Nothing if the truth (interpolated) does not reach both
/// instants.
std::optional<bool> IsTrue(const Trajectory& truth, const Loop& loop);

/// What an estimator's loops were worth.
struct LoopScore {
  std::size_t judged = 0;  ///< Loops of which the truth tells whether they are true.
  std::size_t true_loops = 0;
  std::size_t revisits = 0;  ///< Places that the body had truly been at before.
  std::size_t found = 0;     ///< Revisits at which a true loop was closed.

  /// Share of the loops judged that are true [%]; 100 where there is none: none is false.
  double PrecisionPercent() const;
  /// Share of the revisits that were found [%]; nothing where there is none.
  std::optional<double> RecallPercent() const;
};

/// Places are the true poses at which the body has moved by 0.5 m since the last place. One is a
/// revisit if another, at least 20 s and ten places (5 m of path) earlier, lies within 1.5 m and is
/// turned by at most 30 degrees against it. It is found if a true loop that reaches back by 20 s or
/// more was closed within 1 s of it.
LoopScore ScoreLoops(const Trajectory& truth, const std::vector<Loop>& loops);

}  // namespace drydock::score
