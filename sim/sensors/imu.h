// The simulated IMU.
#pragma once

#include <cstdint>
#include <optional>

#include "sensors_models/noise/imu_noise.h"
#include "sim/motion/motion.h"
#include "sim/sensors/sensor.h"

namespace drydock::sim {

/// What an ideal IMU at the origin of I reads: w_I and R_WI^T (a_W - g).
ImuSample IdealImu(const MotionState& state);

class Imu final : public Sensor {
 public:
  /// `motion` must outlive the sensor. Without `noise` it is ideal; else the sheet says which
  /// errors it has (ImuNoise).
  Imu(const Motion& motion, const ImuSheet& sheet, bool noise, std::uint64_t seed);

  Time NextTime() const override { return SampleTime(Time{}, next_, sheet_.rate_hz); }
  Observation Observe() override;

  /// The biases of the next sample; zero without noise.
  ImuTruth truth() const;

 private:
  const Motion& motion_;
  ImuSheet sheet_;
  std::optional<ImuNoise> noise_;
  std::int64_t next_ = 0;
};

}  // namespace drydock::sim
