#include "sensors_models/models/sonar_beam.h"

#include <cmath>
#include <numbers>

namespace drydock {
namespace {

constexpr double kGoldenAngle = std::numbers::pi * (3.0 - 2.23606797749979);  ///< [rad]

Eigen::Vector3d Direction(double from_axis, double around_axis) {
  return {std::cos(from_axis), std::sin(from_axis) * std::cos(around_axis),
          std::sin(from_axis) * std::sin(around_axis)};
}

}  // namespace

double OneWayBeamPattern(double angle, double beam_width) {
  const double half_widths = 2.0 * angle / beam_width;
  return std::exp2(-half_widths * half_widths);
}

SonarBeamRays MakeSonarBeamRays(double beam_width, std::size_t count) {
  if (beam_width == 0.0) return {Eigen::Vector3d::UnitX(), Eigen::VectorXd::Ones(1)};
  const auto size = static_cast<Eigen::Index>(count);
  SonarBeamRays rays{Eigen::Matrix3Xd(3, size), Eigen::VectorXd(size)};
  // The pattern is a Gaussian: the share of what is sent that lies beyond an angle is the pattern
  // itself. It falls in equal steps from ray to ray, to what is left at a full width.
  const double last = OneWayBeamPattern(beam_width, beam_width);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto number = static_cast<double>(i);
    const double pattern = 1.0 - (1.0 - last) * (number + 0.5) / static_cast<double>(count);
    const double angle = 0.5 * beam_width * std::sqrt(-std::log2(pattern));
    rays.directions.col(i) = Direction(angle, kGoldenAngle * number);
    rays.weights(i) = pattern;
  }
  rays.weights /= rays.weights.sum();
  return rays;
}

}  // namespace drydock
