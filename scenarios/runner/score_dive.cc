#include "scenarios/runner/score_dive.h"

#include "scenarios/runner/run_files.h"
#include "scenarios/version/version.h"

namespace drydock {

score::Scorecard ScoreDive(const Scenario& scenario, const Dive& dive, const Trajectory& truth,
                           const Results& results) {
  score::RunInfo info;
  info.scenario = scenario.name;
  info.seed = scenario.seed;
  info.estimator = scenario.estimator.name;
  info.renderer = dive.RendererName();
  info.commit = Commit();
  info.config_hash = ConfigHash(scenario);
  info.known = KnownMetrics(truth, results);
  return score::Score(info, truth, results.odometry, results.corrected, scenario.criteria);
}

}  // namespace drydock
