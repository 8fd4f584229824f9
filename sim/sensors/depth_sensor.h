// The simulated pressure sensor.
//
//   measured = quantise(lag(depth) + offset + white)
//
// The lag is solved exactly for the depth taken as straight lines between instants of a fixed grid
// of 10 ms (within 6 um of the truth at an acceleration of 0.5 m/s^2), whatever the sensor's rate:
// two sensors of different rate read the same where they read at the same time. It starts in steady
// state. For the rest see PressureNoise.
#pragma once

#include <cstdint>

#include "sensors_models/measurement/rig.h"
#include "sensors_models/noise/first_order_lag.h"
#include "sensors_models/noise/pressure_noise.h"
#include "sim/motion/motion.h"
#include "sim/sensors/sensor.h"

namespace drydock::sim {

class DepthSensor final : public Sensor {
 public:
  /// `motion` must outlive the sensor; `surface_z` is the height of the water's surface [m], in W.
  /// Without `noise` it says exactly the truth.
  DepthSensor(const Motion& motion, const DepthSheet& sheet, double surface_z, bool noise,
              std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

 private:
  double TrueDepth(Time t) const;
  /// What is left of the true depth behind the lag; `t` must not run backwards.
  double FeltDepth(Time t);

  const Motion& motion_;
  DepthSheet sheet_;
  double surface_z_;
  FirstOrderLag lag_;
  Time lag_time_;  ///< Instant of the grid up to which the lag has gone.
  PressureNoise noise_;
  std::int64_t next_ = 0;
};

}  // namespace drydock::sim
