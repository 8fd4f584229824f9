// Which pose of the truth belongs to which pose of the estimate.
#pragma once

#include <cstddef>
#include <vector>

#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// Two poses that are compared: where the body was and where the estimator said it was.
struct PosePair {
  Time t;  ///< The estimate's stamp.
  Pose truth;
  Pose estimate;
};

enum class AssociationMode {
  /// For each stamp of the shorter trajectory (the estimate's, if both are equally long) the
  /// nearest
  /// stamp of the longer one, the earlier on ties, if both are at most `max_difference` apart.
  /// Times
  /// are compared as double seconds, as evo does; several poses may share a partner.
  kNearest,
  /// Truth interpolated at each stamp of the estimate within the truth's span.
  kInterpolate,
};

struct AssociationOptions {
  AssociationMode mode = AssociationMode::kNearest;
  double max_difference_s = 0.01;  ///< Inclusive; of kNearest only.
};

/// The pairs in order of time, and what became of the rest.
struct Association {
  std::vector<PosePair> pairs;
  std::size_t truth_poses = 0;
  std::size_t estimate_poses = 0;
  /// Poses of the trajectory that was gone through (see AssociationMode) without a partner: those
  /// before the other's begin or after its end, and those in a gap of it.
  std::size_t dropped_outside = 0;
  std::size_t dropped_in_gap = 0;
};

Association Associate(const Trajectory& truth, const Trajectory& estimate,
                      const AssociationOptions& options);

}  // namespace drydock::score
