#include "estimator/svin2/initialisation/initialised_start.h"

#include <cmath>

#include <fmt/format.h>

namespace drydock::svin2 {

std::string InitialisationReport::Line() const {
  const auto scale = [](const ScaleEstimate& s) {
    return fmt::format("{:.4f} +- {:.4f}", s.value, s.sigma);
  };
  const auto vector = [](const Eigen::Vector3d& v, int digits) {
    return fmt::format("[{:.{}f} {:.{}f} {:.{}f}]", v.x(), digits, v.y(), digits, v.z(), digits);
  };
  return fmt::format(
      "started {} after {:.2f} s, {} frames and {:.2f} m; scale by depth alone {}, s1 {}, s2 {}; "
      "gravity {:.3f} m/s^2 before the sphere; tilt +- {:.2f} deg, speed +- {:.3f} m/s; chi2 "
      "{:.2f}; "
      "biases {} rad/s, {} m/s^2",
      at_rest ? "from rest" : "in motion", seconds, frames, travelled_m,
      from_depth.has_value() ? scale(*from_depth) : "none", scale(depth_scale),
      scale(alignment_scale), gravity_length, tilt_sigma_rad * 180.0 / M_PI, speed_sigma,
      chi2_per_freedom, vector(bias.gyro, 5), vector(bias.accel, 3));
}

}  // namespace drydock::svin2
