#include "sim/world/closed_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::sim {
namespace {

constexpr int kPieces = 256;
constexpr double kStep = 2.0 * std::numbers::pi / kPieces;

}  // namespace

ClosedCurve::ClosedCurve(const Eigen::Vector3d& centre, std::vector<Harmonic> harmonics)
    : centre_(centre), harmonics_(std::move(harmonics)) {
  lengths_.push_back(0.0);
  for (int i = 0; i < kPieces; ++i) {
    // Simpson's rule.
    const double u = kStep * i;
    const double mean =
        (Slope(u).norm() + 4.0 * Slope(u + 0.5 * kStep).norm() + Slope(u + kStep).norm()) / 6.0;
    lengths_.push_back(lengths_.back() + kStep * mean);
  }
  Check(length() > 0.0, "a curve of no length");
}

double ClosedCurve::ParameterAt(double s) const {
  s -= length() * std::floor(s / length());
  const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
  const auto i = static_cast<int>(next - lengths_.begin()) - 1;
  const double begin = lengths_[static_cast<std::size_t>(i)];
  const double h = *next - begin;
  const double t = (s - begin) / h;
  // Hermite's cubic with du/ds at both ends, so that the pace has no steps.
  const double c = 1.0 - t;
  const double from = kStep * i;
  const double to = kStep * (i + 1);
  return c * c * ((1.0 + 2.0 * t) * from + t * h / Slope(from).norm()) +
         t * t * ((3.0 - 2.0 * t) * to - c * h / Slope(to).norm());
}

Eigen::Vector3d ClosedCurve::Point(double u) const {
  Eigen::Vector3d p = centre_;
  double k = 1.0;
  for (const Harmonic& harmonic : harmonics_) {
    p += std::cos(k * u) * harmonic.cosine + std::sin(k * u) * harmonic.sine;
    k += 1.0;
  }
  return p;
}

Eigen::Vector3d ClosedCurve::Slope(double u) const {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  double k = 1.0;
  for (const Harmonic& harmonic : harmonics_) {
    slope += k * (std::cos(k * u) * harmonic.sine - std::sin(k * u) * harmonic.cosine);
    k += 1.0;
  }
  return slope;
}

Eigen::Vector3d ClosedCurve::At(double s) const { return Point(ParameterAt(s)); }

Eigen::Vector3d ClosedCurve::Ahead(double s) const { return Slope(ParameterAt(s)).normalized(); }

double ClosedCurve::FarthestFrom(const Eigen::Vector3d& point) const {
  double farthest = 0.0;
  for (int i = 0; i < kPieces; ++i)
    farthest = std::max(farthest, (Point(kStep * i) - point).norm());
  return farthest;
}

}  // namespace drydock::sim
