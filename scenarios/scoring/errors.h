// How far an estimate is from the truth: absolute and relative pose errors and their statistics.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "scenarios/scoring/alignment.h"
#include "scenarios/scoring/association.h"

namespace drydock::score {

/// Of a list of errors, in their unit. `standard_deviation` divides by n; `sse` is the sum of
/// squares, in the unit squared.
struct Statistics {
  std::size_t count = 0;
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double standard_deviation = 0.0;
  double min = 0.0;
  double max = 0.0;
  double sse = 0.0;
};

/// Nothing for an empty list.
std::optional<Statistics> Summarize(std::vector<double> values);

/// One value a pair of poses.
struct PoseErrors {
  std::vector<double> translation;  ///< [m]
  std::vector<double> rotation;     ///< [rad], from 0 to pi.
};

/// Absolute pose errors after `alignment`: |p_estimate - p_truth| and |Log(R_estimate^T R_truth)|.
PoseErrors AbsoluteErrors(const std::vector<PosePair>& pairs, const Similarity& alignment);

/// Which two poses a relative error compares.
struct StepOptions {
  enum class Unit { kFrames, kMetres };
  enum class Along { kEstimate, kTruth };

  double step = 5.0;  ///< [frames] (a whole number of at least 1) or [m], above 0.
  Unit unit = Unit::kMetres;
  /// Steps from every pose, overlapping; else one step after the other.
  bool all_pairs = true;
  /// Which trajectory's path is measured, of kMetres only.
  Along along = Along::kEstimate;
  /// The path of a step may differ from `step` by this share; of kMetres with all_pairs only.
  double tolerance = 0.1;
};

/// Indices into `pairs`, from and to, as evo chooses them. By frames: (0,d), (d,2d)... or (i,i+d)
/// for all i. By metres, all pairs: for each i the later j whose path from i is nearest to the
/// step, the first on ties; one after the other: each time the path since the last has reached the
/// step.
std::vector<std::pair<std::size_t, std::size_t>> SelectSteps(const std::vector<PosePair>& pairs,
                                                             const StepOptions& options);

/// Relative pose errors, which need no alignment: of E = (Q_i^-1 Q_j)^-1 (P_i^-1 P_j) with Q truth
/// and P estimate, |t_E| and |Log R_E|.
PoseErrors RelativeErrors(const std::vector<PosePair>& pairs, const StepOptions& options);

}  // namespace drydock::score
