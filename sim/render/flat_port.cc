#include "sim/render/flat_port.h"

#include <cmath>
#include <numbers>

namespace drydock::sim {
namespace {

/// Tangent of a ray's angle in a medium, and how it changes with that in air.
struct Bent {
  double tangent;
  double slope;
};

Bent Refract(double index, double air_tangent) {
  // sin a / sqrt(n^2 - sin^2 a), with sin^2 a = T^2 / (1 + T^2).
  const double n2 = index * index;
  const double square = n2 + (n2 - 1.0) * air_tangent * air_tangent;
  const double root = std::sqrt(square);
  return {air_tangent / root, n2 / (square * root)};
}

}  // namespace

FlatPortConfig ReadFlatPort(YamlReader& yaml) {
  FlatPortConfig port;
  port.enabled = yaml.Boolean("enabled", true);
  port.distance_m = yaml.Real("distance_m", {0.0, 0.2}, port.distance_m);
  port.thickness_m = yaml.Real("thickness_m", {0.0, 0.05}, port.thickness_m);
  port.glass_index = yaml.Real("glass_index", {1.0, 2.0}, port.glass_index);
  port.water_index = yaml.Real("water_index", {1.3, 1.4}, port.water_index);
  port.calibration_distance_m =
      yaml.Real("calibration_distance_m", {0.3, 100.0}, port.calibration_distance_m);
  return port;
}

FlatPort::FlatPort(const FlatPortConfig& config) : config_(config) {}

double FlatPort::widest() const {
  constexpr double kMargin = 2.0 * std::numbers::pi / 180.0;
  return std::tan(std::asin(1.0 / config_.water_index) - kMargin);
}

FlatPort::Ray FlatPort::RayAt(double air_tangent) const {
  const double in_glass = Refract(config_.glass_index, air_tangent).tangent;
  const double in_water = Refract(config_.water_index, air_tangent).tangent;
  return {in_water, config_.distance_m * (air_tangent - in_water) +
                        config_.thickness_m * (in_glass - in_water)};
}

double FlatPort::AirTangent(double ideal, double inverse_depth) const {
  const double air = inverse_depth * config_.distance_m;
  const double glass = inverse_depth * config_.thickness_m;
  const double water = 1.0 - air - glass;
  // The radius grows with tan a, the more slowly the larger it is: Newton's steps from 0 never go
  // too far.
  double tangent = 0.0;
  for (int step = 0; step < 50; ++step) {
    const Bent in_glass = Refract(config_.glass_index, tangent);
    const Bent in_water = Refract(config_.water_index, tangent);
    const double radius = air * tangent + glass * in_glass.tangent + water * in_water.tangent;
    const double slope = air + glass * in_glass.slope + water * in_water.slope;
    const double change = (ideal - radius) / slope;
    tangent += change;
    if (std::abs(change) < 1e-10) break;
  }
  return tangent;
}

Eigen::Vector2d FlatPort::ByInverseDepth(const Eigen::Vector2d& calibrated) const {
  const double radius = calibrated.norm();
  if (radius == 0.0) return Eigen::Vector2d::Zero();
  const double tangent = AirTangent(radius, calibrated_inverse_depth());
  return RayAt(tangent).by_inverse_depth / radius * calibrated;
}

Eigen::Vector2d FlatPort::Calibrated(const Eigen::Vector2d& ideal, double inverse_depth) const {
  const double radius = ideal.norm();
  if (radius == 0.0) return Eigen::Vector2d::Zero();
  const Ray ray = RayAt(AirTangent(radius, inverse_depth));
  return (ray.tangent + calibrated_inverse_depth() * ray.by_inverse_depth) / radius * ideal;
}

}  // namespace drydock::sim
