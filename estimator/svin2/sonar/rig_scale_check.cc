#include "estimator/svin2/sonar/rig_scale_check.h"

#include <cmath>

#include <fmt/format.h>

namespace drydock::svin2 {

void RigScaleCheck::Add(double range, double innovation, double sigma) {
  ++pings_;
  information_ += range * range / (sigma * sigma);
  product_ += range * innovation / (sigma * sigma);
}

std::optional<RigScaleCheck::Finding> RigScaleCheck::Found() const {
  if (pings_ < config_.min_pings || !(information_ > 0.0)) return std::nullopt;
  return Finding{product_ / information_, 1.0 / std::sqrt(information_)};
}

std::optional<std::string> RigScaleCheck::Complaint() {
  const auto found = Found();
  if (said_ || !found || std::abs(found->share) < config_.min_share ||
      std::abs(found->share) < config_.min_sigmas * found->sigma)
    return std::nullopt;
  said_ = true;
  return fmt::format(
      "{} pings find things {:+.1f} +- {:.1f} % further than stereo does: is the baseline wrong?",
      pings_, 100.0 * found->share, 100.0 * found->sigma);
}

}  // namespace drydock::svin2
