#include "sensors_models/models/sonar_model.h"

#include <cmath>
#include <numbers>

namespace drydock {

double SonarHeadAngle(const SonarSheet& sheet, std::int64_t ping) {
  return std::fmod(static_cast<double>(ping) * sheet.step_rad, 2.0 * std::numbers::pi);
}

Eigen::Vector3d SonarBeam(double head_angle) {
  return {std::cos(head_angle), std::sin(head_angle), 0.0};
}

Eigen::Vector3d SonarPoint(double head_angle, double range) {
  return range * SonarBeam(head_angle);
}

double SonarBinLength(const SonarSheet& sheet) { return sheet.max_range_m / sheet.bins; }

double SonarBinCentre(const SonarSheet& sheet, std::size_t bin) {
  return (static_cast<double>(bin) + 0.5) * SonarBinLength(sheet);
}

double SonarRangeSigma(const SonarSheet& sheet) {
  const double rounding = sheet.bins > 0 ? SonarBinLength(sheet) / std::sqrt(12.0) : 0.0;
  return std::hypot(sheet.range_noise_m, rounding);
}

}  // namespace drydock
