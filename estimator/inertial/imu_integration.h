// Dead reckoning over one IMU interval.
#pragma once

#include "estimator/interface/estimator.h"

namespace drydock {

/// Gravity [m/s^2], in W (z up).
inline const Eigen::Vector3d kGravity(0.0, 0.0, -9.81);

/// Carries `state` (at the time of `before`) to the time of `after` by the midpoint rule: the mean
/// of the two bias-free rates turns the body, the mean of the two forces, each turned into W, moves
/// it. Error of third order in the step.
NavState IntegrateMidpoint(const NavState& state, const ImuSample& before, const ImuSample& after,
                           Time t_after);

}  // namespace drydock
