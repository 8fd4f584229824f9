// The result of a run: scorecard.json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scoring/criteria.h"
#include "scenarios/scoring/metrics.h"
#include "scenarios/scoring/trajectory_score.h"
#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// What was run, and the figures that others than the trajectories tell.
struct RunInfo {
  std::string scenario;
  std::uint64_t seed = 0;
  std::string estimator;
  std::string renderer;
  std::string commit;
  std::string config_hash;
  /// When the last fault of the scenario ended; nothing in a run without faults.
  std::optional<Time> last_fault_end;
  /// Figures known elsewhere (loops, maps, initialisation…). One that is set here stands, even
  /// where the trajectories would give another.
  Metrics known;
};

struct Scorecard {
  RunInfo run;
  double path_length_m = 0.0;  ///< Of the truth.
  double duration_s = 0.0;     ///< Of the truth.
  Metrics metrics;
  /// How the final trajectory was laid upon the truth for ate_rmse_m; nothing if it could not be.
  std::optional<Similarity> alignment;
  std::vector<CriterionResult> criteria;

  /// Every criterion is met; also true where there is none.
  bool Passed() const;
};

/// Scores a run. `odometry` is what was published at the time, `final_trajectory` what the
/// estimator says in the end; every metric but ate_odometry_rmse_m, ate_to_odometry,
/// continuity_percent, init_time_s, init_scale_error_percent and recovery_time_s is of the latter.
/// Trajectories that are empty or too short leave metrics unset, and criteria on those fail.
/// InputError for an empty truth or a criterion that makes no sense.
Scorecard Score(const RunInfo& run, const Trajectory& truth, const Trajectory& odometry,
                const Trajectory& final_trajectory, const std::vector<Criterion>& criteria);

}  // namespace drydock::score
