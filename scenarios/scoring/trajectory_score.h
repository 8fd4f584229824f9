// Two trajectories compared.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scenarios/scoring/alignment.h"
#include "scenarios/scoring/association.h"
#include "scenarios/scoring/errors.h"
#include "scenarios/scoring/metrics.h"
#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// What was compared and how it came out.
struct TrajectoryScore {
  Alignment alignment = Alignment::kSe3;
  Similarity transform;  ///< Takes the estimate's world to the truth's.
  AssociationOptions association_options;
  Association association;
  double path_length_m = 0.0;  ///< Of the truth.
  double duration_s = 0.0;     ///< Of the truth.
  Statistics ape_translation;  ///< [m]
  Statistics ape_rotation;     ///< [rad]
  /// Steps of 5 m along the estimate, all pairs; nothing if the estimate has none.
  std::optional<Statistics> rpe_translation;  ///< [m]
  std::optional<Statistics> rpe_rotation;     ///< [rad]
  Metrics metrics;  ///< Those that two trajectories determine; ate_* under `alignment`.
};

/// InputError that says why if nothing can be associated or the pairs do not determine `alignment`.
TrajectoryScore ScoreTrajectories(const Trajectory& truth, const Trajectory& estimate,
                                  Alignment alignment, const AssociationOptions& options = {});

/// The same, but nothing instead of an error.
std::optional<TrajectoryScore> TryScoreTrajectories(const Trajectory& truth,
                                                    const Trajectory& estimate, Alignment alignment,
                                                    const AssociationOptions& options = {});

/// 100 (1/s - 1) with s the scale of Sim(3) alignment; nothing where the pairs do not determine it.
std::optional<double> ScaleErrorPercent(const std::vector<PosePair>& pairs);

/// Time with a valid estimate as a share of the truth's time from the estimate's first pose on
/// [0..1]. Between two poses at most `max_gap` apart the estimate is valid, as it is from its last
/// pose to the truth's end if that is at most `max_gap`. The wait for the first pose counts apart
/// (init_time_s). 0 if the estimate has no pose within the truth's span.
double Continuity(const Trajectory& truth, const Trajectory& estimate, Duration max_gap);

/// Gaps longer than this count as lost [ns].
inline constexpr Duration kMaxGap{kNanosecondsPerSecond};

}  // namespace drydock::score
