#include "scenarios/runner/score_dive.h"

#include <optional>

#include "scenarios/runner/run_files.h"
#include "scenarios/scoring/alignment.h"
#include "scenarios/scoring/association.h"
#include "scenarios/scoring/maps.h"
#include "scenarios/version/version.h"

namespace drydock {
namespace {

/// Lays the map upon the world as ate_rmse_m lays the trajectory.
void FillMaps(const Dive& dive, const Trajectory& truth, const Results& results,
              score::Metrics& metrics) {
  const auto alignment =
      score::Align(score::Associate(truth, results.corrected, {}).pairs, score::Alignment::kSe3);
  if (!alignment) return;
  const auto distance = [&dive](const Eigen::Vector3d& point) -> std::optional<double> {
    const auto nearest = dive.rays().Nearest(point, score::kFarthestMapPoint);
    return nearest ? std::optional(nearest->range) : std::nullopt;
  };
  metrics.sonar_map_rmse_m = score::MapRmse(results.map.sonar, *alignment, distance);
  metrics.landmark_map_rmse_m = score::MapRmse(results.map.landmarks, *alignment, distance);
}

}  // namespace

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
  FillMaps(dive, truth, results, info.known);
  return score::Score(info, truth, results.odometry, results.corrected, scenario.criteria);
}

}  // namespace drydock
