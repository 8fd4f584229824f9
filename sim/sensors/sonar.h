// The simulated rotating profiling sonar.
#pragma once

#include <cstdint>

#include "sensors_models/base/random_stream.h"
#include "sensors_models/measurement/rig.h"
#include "sim/motion/motion.h"
#include "sim/sensors/sensor.h"
#include "sim/world/ray_scene.h"

namespace drydock::sim {

/// One exact ray a ping, along the beam's axis, with white noise on the range. The echo's intensity
/// is the cosine of the angle of incidence.
class Sonar final : public Sensor {
 public:
  /// Everything passed by reference must outlive the sensor.
  Sonar(const Motion& motion, const World& world, const RayScene& rays, const SonarSheet& sheet,
        bool noise, std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

 private:
  const Motion& motion_;
  const World& world_;
  const RayScene& rays_;
  SonarSheet sheet_;
  double noise_m_;
  RandomStream stream_;
  std::int64_t next_ = 0;
};

}  // namespace drydock::sim
