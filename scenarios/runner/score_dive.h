// What an estimator was worth on a dive.
#pragma once

#include "scenarios/results/result_files.h"
#include "scenarios/runner/dive.h"
#include "scenarios/scoring/scorecard.h"

namespace drydock {

/// Scores what `scenario.estimator` said on `dive` against its `truth`, by the scenario's criteria.
score::Scorecard ScoreDive(const Scenario& scenario, const Dive& dive, const Trajectory& truth,
                           const Results& results);

}  // namespace drydock
