// Scores as JSON: the same bytes for the same score.
#pragma once

#include <string>

#include "scenarios/scoring/scorecard.h"
#include "scenarios/scoring/trajectory_score.h"

namespace drydock::score {

/// scorecard.json: the keys in a fixed order, null for what does not exist, a line feed at the end.
std::string ToJson(const Scorecard& card);

/// What `drydock score --json` prints: the metrics under the scorecard's names, the alignment with
/// its transform, what was associated and dropped, and the statistics of all errors.
std::string ToJson(const TrajectoryScore& score);

}  // namespace drydock::score
