#include "estimator/svin2/preintegration/imu_segments.h"

#include <algorithm>

namespace drydock::svin2 {
namespace {

std::vector<TimedImuSample> UsableSamples(std::span<const TimedImuSample> samples) {
  std::vector<TimedImuSample> usable;
  usable.reserve(samples.size() + 2);
  for (const TimedImuSample& sample : samples) {
    const bool finite =
        sample.sample.angular_rate.allFinite() && sample.sample.specific_force.allFinite();
    if (finite && (usable.empty() || sample.t > usable.back().t)) usable.push_back(sample);
  }
  return usable;
}

ImuSample Interpolate(const TimedImuSample& a, const TimedImuSample& b, Time t) {
  const double share = (t - a.t).Seconds() / (b.t - a.t).Seconds();
  return {(1.0 - share) * a.sample.angular_rate + share * b.sample.angular_rate,
          (1.0 - share) * a.sample.specific_force + share * b.sample.specific_force};
}

bool Saturated(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double range) {
  return range > 0.0 && std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) >= range;
}

ImuSegment Cut(const TimedImuSample& a, const TimedImuSample& b, Time begin, Time end,
               const ImuNoiseModel& noise) {
  const Time from = std::max(a.t, begin);
  const Time to = std::min(b.t, end);
  ImuSegment segment;
  segment.length = to - from;
  segment.from = Interpolate(a, b, from);
  segment.to = Interpolate(a, b, to);
  const bool gap = b.t - a.t > Duration::FromSeconds(noise.longest_step_s);
  const bool doubt_gyro =
      gap || Saturated(a.sample.angular_rate, b.sample.angular_rate, noise.gyro_range);
  const bool doubt_accel =
      gap || Saturated(a.sample.specific_force, b.sample.specific_force, noise.accel_range);
  segment.gyro_noise_density = noise.gyro_noise_density * (doubt_gyro ? noise.doubt_factor : 1.0);
  segment.accel_noise_density =
      noise.accel_noise_density * (doubt_accel ? noise.doubt_factor : 1.0);
  return segment;
}

}  // namespace

std::vector<ImuSegment> CutImuSegments(std::span<const TimedImuSample> samples, Time begin,
                                       Time end, const ImuNoiseModel& noise) {
  std::vector<TimedImuSample> knots = UsableSamples(samples);
  if (knots.empty() || end <= begin) return {};
  if (knots.front().t > begin) knots.insert(knots.begin(), {begin, knots.front().sample});
  if (knots.back().t < end) knots.push_back({end, knots.back().sample});

  std::vector<ImuSegment> segments;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    if (knots[k + 1].t <= begin || knots[k].t >= end) continue;
    segments.push_back(Cut(knots[k], knots[k + 1], begin, end, noise));
  }
  return segments;
}

}  // namespace drydock::svin2
