#include "sensors_models/models/equidistant.h"

#include <algorithm>
#include <cmath>

namespace drydock {
namespace {

using Coefficients = EquidistantLens::Coefficients;

/// Closer to the axis than this, on z = 1, a ray is the axis.
constexpr double kAxis = 1e-12;
/// With a slope below this b() counts as folded, as CameraModel has it of other lenses.
constexpr double kLeastSlope = 1e-3;

double Bend(const Coefficients& k, double t) {
  const double t2 = t * t;
  return t * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
}

/// d(Bend) / dt.
double Slope(const Coefficients& k, double t) {
  const double t2 = t * t;
  return 1.0 + t2 * (3.0 * k[0] + t2 * (5.0 * k[1] + t2 * (7.0 * k[2] + t2 * 9.0 * k[3])));
}

/// The t in [0, reach], where Bend() rises, with Bend(t) = b: Newton, kept between what is known to
/// be too little and too much.
double Unbend(const Coefficients& k, double reach, double b) {
  double low = 0.0, high = reach;
  double t = std::min(b, reach);
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double error = Bend(k, t) - b;
    (error > 0.0 ? high : low) = t;
    double next = t - error / Slope(k, t);
    if (!(next > low && next < high)) next = error == 0.0 ? t : 0.5 * (low + high);
    const double step = std::abs(next - t);
    t = next;
    if (step <= 1e-15) break;
  }
  return t;
}

}  // namespace

Eigen::Vector2d EquidistantLens::Distort(const Coefficients& k, const Eigen::Vector2d& ideal) {
  const double r = ideal.norm();
  if (r < kAxis) return ideal;
  return Bend(k, std::atan(r)) / r * ideal;
}

Eigen::Matrix2d EquidistantLens::DistortJacobian(const Coefficients& k,
                                                 const Eigen::Vector2d& ideal) {
  const double r = ideal.norm();
  if (r < kAxis) return Eigen::Matrix2d::Identity();
  // Along the radius b'(t) dt/dr, across it b / r.
  const double t = std::atan(r);
  const double across = Bend(k, t) / r;
  const double along = Slope(k, t) / (1.0 + r * r);
  const Eigen::Vector2d radius = ideal / r;
  return across * Eigen::Matrix2d::Identity() + (along - across) * radius * radius.transpose();
}

double EquidistantLens::Reach(const Coefficients& k) {
  constexpr int kSteps = 256;  // 0.3 degrees: a fold between two of them would be undone at once.
  double reach = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = kWidest * i / kSteps;
    if (!(Slope(k, t) > kLeastSlope)) return reach;
    reach = t;
  }
  return reach;
}

std::optional<Eigen::Vector2d> EquidistantLens::Undistort(const Coefficients& k, double reach,
                                                          const Eigen::Vector2d& distorted) {
  const double b = distorted.norm();
  if (b < kAxis) return distorted;
  if (!(b <= Bend(k, reach))) return std::nullopt;
  return std::tan(Unbend(k, reach, b)) / b * distorted;
}

}  // namespace drydock
