// Trajectories whose scores can be worked out by hand.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "sensors_models/base/trajectory.h"

namespace drydock::score {

/// `count` poses `step_s` apart at the given positions, level and facing along x.
inline Trajectory MakeTrajectory(int count, double step_s,
                                 const std::function<Eigen::Vector3d(double)>& position) {
  Trajectory trajectory;
  for (int i = 0; i < count; ++i) {
    const double t = i * step_s;
    trajectory.push_back({Time::FromSeconds(t), Pose(Eigen::Quaterniond::Identity(), position(t))});
  }
  return trajectory;
}

/// A climbing curve that fixes every alignment: 30 s at 10 Hz.
inline Trajectory Helix() {
  return MakeTrajectory(301, 0.1, [](double t) {
    return Eigen::Vector3d(3.0 * std::cos(0.4 * t), 2.0 * std::sin(0.4 * t), 0.1 * t);
  });
}

/// Every pose moved by one transform of the world.
inline Trajectory Moved(Trajectory trajectory, const Pose& by, double scale = 1.0) {
  for (StampedPose& pose : trajectory) {
    pose.T_WI = Pose(by.q() * pose.T_WI.q(), scale * (by.q() * pose.T_WI.p()) + by.p());
  }
  return trajectory;
}

}  // namespace drydock::score
