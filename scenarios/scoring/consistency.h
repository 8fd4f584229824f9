// Does an estimator know how wrong it is?
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// A pose that an estimator published with its covariance.
struct Belief {
  Time t;
  Pose T_WI;
  /// Of [dp; da] as in Pose::BoxPlus: left perturbation [m; rad], in the estimator's W.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  int map_id = 0;  ///< Between maps the relation of the worlds is not known.
};

/// Average normalised estimation error squared, per degree of freedom: 1 for an estimator whose
/// covariance is right, above 1 for one that trusts itself too much.
struct Anees {
  double position = 0.0;
  double orientation = 0.0;
  std::size_t count = 0;  ///< Of the beliefs that were averaged.
};

/// The first belief of each map is laid upon the truth (interpolated at its time) by position and
/// yaw, which no inertial estimator can know; of the others, e^T P^-1 e / 3 is averaged, once with
/// e = dp and once with e = da, where estimate = truth.BoxPlus([dp; da]) in the truth's world and P
/// is the belief's block turned into it. Beliefs outside the truth's span and those whose blocks
/// are not positive definite are left out; nothing if none is left.
std::optional<Anees> ComputeAnees(const Trajectory& truth, const std::vector<Belief>& beliefs);

}  // namespace drydock::score
