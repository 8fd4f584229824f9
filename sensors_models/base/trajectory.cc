#include "sensors_models/base/trajectory.h"

#include <algorithm>

namespace drydock {

double PathLength(const Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += (trajectory[i].T_WI.p() - trajectory[i - 1].T_WI.p()).norm();
  }
  return length;
}

std::optional<Pose> Interpolate(const Trajectory& trajectory, Time t) {
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), t,
                       [](const StampedPose& pose, Time time) { return pose.t < time; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->t == t) return after->T_WI;
  if (after == trajectory.begin()) return std::nullopt;
  const StampedPose& a = *(after - 1);
  const StampedPose& b = *after;
  const double share = (t - a.t).Seconds() / (b.t - a.t).Seconds();
  return Pose(a.T_WI.q().slerp(share, b.T_WI.q()), a.T_WI.p() + share * (b.T_WI.p() - a.T_WI.p()));
}

}  // namespace drydock
