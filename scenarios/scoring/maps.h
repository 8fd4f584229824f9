// How far an estimator's map is from what is there.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "scenarios/scoring/alignment.h"

namespace drydock::score {

/// A point of the map counts as this far off at most [m]: a few wild ones are not to hide all
/// others, nor to go unseen.
inline constexpr double kFarthestMapPoint = 1.0;

/// The distance of a point [m, in the truth's W] to the nearest true surface, at least where that
/// is nearer than kFarthestMapPoint; nothing otherwise.
using SurfaceDistance = std::function<std::optional<double>(const Eigen::Vector3d& point)>;

/// Root mean square of the points' distances to the true surfaces after `alignment`, each counted
/// as kFarthestMapPoint at most [m]; nothing of no points.
std::optional<double> MapRmse(const std::vector<Eigen::Vector3d>& points,
                              const Similarity& alignment, const SurfaceDistance& distance);

}  // namespace drydock::score
