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

}  // namespace drydock
