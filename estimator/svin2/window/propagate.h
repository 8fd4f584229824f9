// States carried on by the IMU alone.
#pragma once

#include "estimator/interface/estimator.h"
#include "estimator/svin2/preintegration/imu_preintegration.h"

namespace drydock::svin2 {

/// `state` (at imu.begin()) at imu.end(), with its own biases taken off the samples.
NavState Propagate(const NavState& state, const ImuPreintegration& imu);

}  // namespace drydock::svin2
