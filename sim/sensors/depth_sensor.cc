#include "sim/sensors/depth_sensor.h"

#include "sensors_models/models/pressure_model.h"

namespace drydock::sim {
namespace {

constexpr Duration kLagStep{10'000'000};
constexpr PressureEffects kNothing{
    .white_noise = false, .offset = false, .lag = false, .quantisation = false};

}  // namespace

DepthSensor::DepthSensor(const Motion& motion, const DepthSheet& sheet, double surface_z,
                         bool noise, std::uint64_t seed)
    : motion_(motion),
      sheet_(noise ? sheet : KeepEffects(sheet, kNothing)),
      surface_z_(surface_z),
      lag_(sheet_.lag_s, TrueDepth(Time{})),
      noise_(sheet_, seed) {}

double DepthSensor::TrueDepth(Time t) const {
  return DepthBelowSurface(motion_.At(t).T_WI, sheet_.p_ID, surface_z_);
}

double DepthSensor::FeltDepth(Time t) {
  if (sheet_.lag_s == 0.0) return TrueDepth(t);
  for (Time next = lag_time_ + kLagStep; next <= t; next = next + kLagStep) {
    lag_.Advance(TrueDepth(next), kLagStep.Seconds());
    lag_time_ = next;
  }
  // A copy goes the rest of the way, so that no reading leaves a trace in later ones.
  FirstOrderLag now = lag_;
  return now.Advance(TrueDepth(t), (t - lag_time_).Seconds());
}

Observation DepthSensor::Observe() {
  const Time t = NextTime();
  ++next_;
  return {{t, t, DepthSample{noise_.Corrupt(FeltDepth(t))}}, {}};
}

}  // namespace drydock::sim
