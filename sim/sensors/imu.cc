#include "sim/sensors/imu.h"

namespace drydock::sim {

ImuSample IdealImu(const MotionState& state) {
  return {state.w_I, state.T_WI.q().conjugate() * (state.a_W - kGravity_W)};
}

Imu::Imu(const Motion& motion, const ImuSheet& sheet, bool noise, std::uint64_t seed)
    : motion_(motion), sheet_(sheet) {
  if (noise) noise_.emplace(sheet, seed);
}

Observation Imu::Observe() {
  const Time t = NextTime();
  ++next_;
  ImuSample sample = IdealImu(motion_.At(t));
  const ImuTruth biases = truth();
  if (noise_) sample = noise_->Corrupt(sample);
  return {{t, t, sample}, biases};
}

ImuTruth Imu::truth() const {
  return noise_ ? ImuTruth{noise_->gyro_bias(), noise_->accel_bias()} : ImuTruth{};
}

}  // namespace drydock::sim
