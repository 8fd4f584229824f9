#include "scenarios/scoring/maps.h"

#include <cmath>

namespace drydock::score {

std::optional<double> MapRmse(const std::vector<Eigen::Vector3d>& points,
                              const Similarity& alignment, const SurfaceDistance& distance) {
  if (points.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Eigen::Vector3d& point : points) {
    const double far = distance(alignment * point).value_or(kFarthestMapPoint);
    // Written so that what is no number counts as far, too.
    const double counted = far < kFarthestMapPoint ? far : kFarthestMapPoint;
    sum += counted * counted;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace drydock::score
