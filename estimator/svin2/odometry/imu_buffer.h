// The latest IMU samples.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "estimator/svin2/preintegration/imu_preintegration.h"

namespace drydock::svin2 {

/// Keeps samples in order of time, as long as they may be needed.
class ImuBuffer {
 public:
  explicit ImuBuffer(const ImuNoiseModel& noise) : noise_(noise) {}

  const ImuNoiseModel& noise() const { return noise_; }

  /// False, and the sample is not kept, if it is not finite or not later than the one before.
  bool Add(Time t, const ImuSample& sample);
  /// Forgets what is older than the last sample at or before `t`.
  void ForgetBefore(Time t);

  /// Whether there is a sample at or after `t`.
  bool Covers(Time t) const { return !samples_.empty() && samples_.back().t >= t; }
  bool IsEmpty() const { return samples_.empty(); }

  /// Nothing if `end` <= `begin` or there are no samples at all.
  std::optional<ImuPreintegration> Integrate(Time begin, Time end, const ImuBias& bias) const;
  /// Samples from the last one at or before `begin` to the first one at or after `end`.
  std::vector<TimedImuSample> Between(Time begin, Time end) const;

 private:
  ImuNoiseModel noise_;
  std::deque<TimedImuSample> samples_;
};

}  // namespace drydock::svin2
