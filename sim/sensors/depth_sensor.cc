#include "sim/sensors/depth_sensor.h"

#include "sensors_models/models/pressure_model.h"

namespace drydock::sim {

DepthSensor::DepthSensor(const Motion& motion, const DepthSheet& sheet, double surface_z,
                         bool noise, std::uint64_t seed)
    : motion_(motion),
      sheet_(sheet),
      surface_z_(surface_z),
      noise_m_(noise ? sheet.noise_m : 0.0),
      stream_(seed, "pressure0/white") {}

Observation DepthSensor::Observe() {
  const Time t = NextTime();
  ++next_;
  const double truth = DepthBelowSurface(motion_.At(t).T_WI, sheet_.p_ID, surface_z_);
  return {{t, t, DepthSample{truth + noise_m_ * stream_.Gaussian()}}, {}};
}

}  // namespace drydock::sim
