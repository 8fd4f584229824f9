// Trajectories as a picture.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/trajectory.h"

namespace drydock::report {

struct NamedTrajectory {
  std::string name;
  Trajectory trajectory;  ///< In the truth's world, that is aligned already where that is wanted.
};

/// Draws the truth and the estimates from above (x right, y up), from the side (the longer of x and
/// y right, z up), both with equal scales, and, where there are estimates, each one's distance from
/// the truth over time. Lines break where an estimate has no pose for more than a second. 1200 px
/// wide, CV_8UC3; the height depends on the path's shape. Also draws empty trajectories: empty
/// axes.
cv::Mat DrawTrajectories(const std::string& title, const Trajectory& truth,
                         const std::vector<NamedTrajectory>& estimates);

}  // namespace drydock::report
