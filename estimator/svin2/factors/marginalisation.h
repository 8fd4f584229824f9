// Takes states out of the optimisation without forgetting what they tell about the others.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>

#include "estimator/svin2/factors/linear_prior_factor.h"

namespace drydock::svin2 {

/// One factor and the blocks that are its parameters.
struct MarginalTerm {
  const ceres::CostFunction* cost = nullptr;
  const ceres::LossFunction* loss = nullptr;  ///< None: the plain square.
  std::vector<std::size_t> blocks;            ///< Indices into the blocks, in the factor's order.
};

/// The cost of `terms` as a function of the blocks `kept` alone, in this order, minimised over all
/// other blocks (Schur complement), with each term linearised at `blocks`.
///
/// First estimates: a block that a LinearPrior holds already must come with the value in that
/// prior's x0, and the old prior be one of the terms; then all terms ever marginalised are
/// linearised at the same point, and no direction that nothing measures (the gauge) gains
/// information by a change of that point.
///
/// Blocks go one after the other, the smallest first, so that landmarks cost little. A direction is
/// taken for unknown if its eigenvalue is below 1e-13 of the largest, after scaling the information
/// to a diagonal of 1 (units of blocks differ by orders of magnitude); it is left out on either
/// side: a pseudo-inverse. That is what rounding leaves of 0; much above it would forget where a
/// chain of precise steps is in W, once that is known to a metre only. Robust losses weigh a term
/// by the loss's slope at its linearisation. Terms that cannot be evaluated, or not to finite
/// numbers, are left out.
LinearPrior Marginalise(std::span<const BlockValues> blocks, std::span<const MarginalTerm> terms,
                        std::span<const std::size_t> kept);

}  // namespace drydock::svin2
