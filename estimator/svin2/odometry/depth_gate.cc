#include "estimator/svin2/odometry/depth_gate.h"

#include <cmath>

namespace drydock::svin2 {

bool DepthGate::Believes(Time t, double error) {
  const double since = last_believed_ ? (t - *last_believed_).Seconds() : 0.0;
  if (!(std::abs(error) <= config_.tolerance_m + config_.growth_m_per_s * std::abs(since)))
    return false;
  last_believed_ = t;
  return true;
}

}  // namespace drydock::svin2
