#include "estimator/svin2/odometry/imu_buffer.h"

#include <algorithm>

namespace drydock::svin2 {

bool ImuBuffer::Add(Time t, const ImuSample& sample) {
  if (!sample.angular_rate.allFinite() || !sample.specific_force.allFinite()) return false;
  if (!samples_.empty() && t <= samples_.back().t) return false;
  samples_.push_back({t, sample});
  return true;
}

void ImuBuffer::ForgetBefore(Time t) {
  while (samples_.size() > 1 && samples_[1].t <= t) samples_.pop_front();
}

std::vector<TimedImuSample> ImuBuffer::Between(Time begin, Time end) const {
  const auto earlier = [](Time t, const TimedImuSample& sample) { return t < sample.t; };
  const auto later = [](const TimedImuSample& sample, Time t) { return sample.t < t; };
  auto from = std::upper_bound(samples_.begin(), samples_.end(), begin, earlier);
  if (from != samples_.begin()) --from;
  auto to = std::lower_bound(samples_.begin(), samples_.end(), end, later);
  if (to != samples_.end()) ++to;
  if (from >= to) return {};
  return {from, to};
}

std::optional<ImuPreintegration> ImuBuffer::Integrate(Time begin, Time end,
                                                      const ImuBias& bias) const {
  if (end <= begin) return std::nullopt;
  return ImuPreintegration::Over(Between(begin, end), begin, end, bias, noise_);
}

}  // namespace drydock::svin2
