// A smooth motion with derivatives in closed form, and the exact IMU readings along it.
#pragma once

#include <cmath>
#include <vector>

#include "estimator/inertial/imu_integration.h"
#include "estimator/interface/estimator.h"
#include "estimator/svin2/preintegration/imu_segments.h"

namespace drydock::svin2::testing {

/// The true state of a body that sways a few decimetres and turns a few tenths of a radian, at `t`,
/// with the given biases.
inline NavState MotionAt(Time t) {
  const double s = t.Seconds();
  const double yaw = 0.8 * std::sin(0.5 * s);
  const double pitch = 0.3 * std::sin(0.9 * s + 0.4);
  NavState state;
  state.t = t;
  state.T_WI =
      Pose(FromYawPitchRoll(yaw, pitch, 0.2),
           {0.2 * s + 0.3 * std::sin(0.7 * s), 0.4 * std::cos(0.6 * s), 0.2 * std::sin(1.1 * s)});
  state.v_W = {0.2 + 0.21 * std::cos(0.7 * s), -0.24 * std::sin(0.6 * s), 0.22 * std::cos(1.1 * s)};
  return state;
}

/// What an IMU with these biases reads, without noise.
inline ImuSample MotionImu(Time t, const Eigen::Vector3d& gyro_bias = Eigen::Vector3d::Zero(),
                           const Eigen::Vector3d& accel_bias = Eigen::Vector3d::Zero()) {
  const double s = t.Seconds();
  const double pitch = 0.3 * std::sin(0.9 * s + 0.4);
  const double yaw_rate = 0.4 * std::cos(0.5 * s);
  const double pitch_rate = 0.27 * std::cos(0.9 * s + 0.4);
  const Eigen::Vector3d acceleration(-0.147 * std::sin(0.7 * s), -0.144 * std::cos(0.6 * s),
                                     -0.242 * std::sin(1.1 * s));
  const Eigen::Quaterniond roll = FromYawPitchRoll(0.0, 0.0, 0.2);
  const Eigen::Quaterniond pitch_roll = FromYawPitchRoll(0.0, pitch, 0.2);
  ImuSample sample;
  // Yaw turns about W's z, pitch about the y axis after yaw; both seen from the body.
  sample.angular_rate = pitch_roll.conjugate() * Eigen::Vector3d(0, 0, yaw_rate) +
                        roll.conjugate() * Eigen::Vector3d(0, pitch_rate, 0) + gyro_bias;
  sample.specific_force = MotionAt(t).T_WI.q().conjugate() * (acceleration - kGravity) + accel_bias;
  return sample;
}

/// Readings every `period` from a little before `begin` to a little after `end`, on the multiples
/// of the period.
inline std::vector<TimedImuSample> MotionSamples(
    Time begin, Time end, Duration period,
    const Eigen::Vector3d& gyro_bias = Eigen::Vector3d::Zero(),
    const Eigen::Vector3d& accel_bias = Eigen::Vector3d::Zero()) {
  std::vector<TimedImuSample> samples;
  for (Time t{begin.ns / period.ns * period.ns}; t < end + period; t = t + period) {
    samples.push_back({t, MotionImu(t, gyro_bias, accel_bias)});
  }
  return samples;
}

}  // namespace drydock::svin2::testing
