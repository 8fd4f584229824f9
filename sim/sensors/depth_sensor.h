// The simulated pressure sensor.
#pragma once

#include <cstdint>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/rig.h"
#include "sim/motion/motion.h"
#include "sim/sensors/sensor.h"

namespace drydock::sim {

class DepthSensor final : public Sensor {
 public:
  /// `motion` must outlive the sensor; `surface_z` is the height of the water's surface [m], in W.
  DepthSensor(const Motion& motion, const DepthSheet& sheet, double surface_z, bool noise,
              std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

 private:
  const Motion& motion_;
  DepthSheet sheet_;
  double surface_z_;
  double noise_m_;
  RandomStream stream_;
  std::int64_t next_ = 0;
};

}  // namespace drydock::sim
