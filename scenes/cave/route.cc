#include "scenes/cave/route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

/// How far along from `a` (0) to `b` (1) is nearest to `p`.
template <typename Vector>
double NearestFraction(const Vector& a, const Vector& b, const Vector& p) {
  const Vector along = b - a;
  const double length2 = along.squaredNorm();
  return length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace

Route::Route(std::vector<Vector3d> points) : points_(std::move(points)) {
  Check(points_.size() >= 2, "a route needs two points, not {}", points_.size());
  for (std::size_t i = 1; i < points_.size(); ++i)
    longest_ = std::max(longest_, (points_[i] - points_[i - 1]).norm());
}

double Route::Distance(const Vector3d& p) const {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vector3d& a = points_[i - 1];
    const double t = NearestFraction(a, points_[i], p);
    least = std::min(least, (a + t * (points_[i] - a) - p).squaredNorm());
  }
  return std::sqrt(least);
}

Route::Below Route::Over(double x, double y) const {
  Below over;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vector3d& a = points_[i - 1];
    const Vector2d a2 = a.head<2>();
    const double t = NearestFraction<Vector2d>(a2, points_[i].head<2>(), {x, y});
    const Vector3d q = a + t * (points_[i] - a);
    const double squared = (q.head<2>() - Vector2d(x, y)).squaredNorm();
    if (squared < least) over.z = q.z();
    least = std::min(least, squared);
  }
  over.distance = std::sqrt(least);
  return over;
}

bool Route::IsFarther(const Vector3d& p, double distance) const {
  const double reach = distance + longest_;
  return std::all_of(points_.begin(), points_.end(),
                     [&](const Vector3d& q) { return (q - p).squaredNorm() > reach * reach; });
}

}  // namespace drydock::scenes::cave
