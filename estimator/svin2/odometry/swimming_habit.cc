#include "estimator/svin2/odometry/swimming_habit.h"

#include <algorithm>
#include <cmath>

namespace drydock::svin2 {

void SwimmingHabit::Learn(const NavState& state) {
  const Eigen::Vector3d v_I = state.T_WI.q().conjugate() * state.v_W;
  const double share =
      last_ ? 1.0 - std::exp(-(state.t - *last_).Seconds() / config_.memory_s) : 1.0;
  v_I_ += share * (v_I - v_I_);
  last_ = state.t;
}

std::optional<double> SwimmingHabit::SigmaEach(Duration interval) const {
  if (config_.sigma <= 0.0 || interval <= Duration{}) return std::nullopt;
  const double alike = 2.0 * config_.correlation_s / interval.Seconds();
  return config_.sigma * std::sqrt(std::max(alike, 1.0));
}

}  // namespace drydock::svin2
