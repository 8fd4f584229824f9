// IMU samples between two instants, cut to fit.
#pragma once

#include <span>
#include <vector>

#include "estimator/svin2/preintegration/imu_noise_model.h"
#include "sensors_models/base/time.h"
#include "sensors_models/measurement/measurement.h"

namespace drydock::svin2 {

struct TimedImuSample {
  Time t;
  ImuSample sample;
};

/// A piece of time over which rate and force go linearly from one reading to the next.
struct ImuSegment {
  Duration length;  ///< > 0.
  ImuSample from, to;
  double gyro_noise_density = 0.0;   ///< With doubt, if there is any [rad/s/sqrt(Hz)].
  double accel_noise_density = 0.0;  ///< With doubt, if there is any [m/s^2/sqrt(Hz)].
};

/// Cuts `samples` into segments that fill [begin, end] without a hole. Readings at `begin` and
/// `end` are interpolated; where samples start too late or end too early, the nearest one is held.
/// Noise is raised by noise.doubt_factor in segments that touch a saturated reading (of that sensor
/// alone) and in gaps. Samples that are not finite or not later than the one before are left out.
/// Empty if end <= begin or if there are no samples.
std::vector<ImuSegment> CutImuSegments(std::span<const TimedImuSample> samples, Time begin,
                                       Time end, const ImuNoiseModel& noise);

}  // namespace drydock::svin2
