// Where the points of a keyframe are.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"

namespace drydock::svin2 {

/// For each of the keyframe's points where it is [m, in the body's frame at the keyframe]: as the
/// window had it, else by this keyframe's stereo; nothing where neither knows.
std::vector<std::optional<Eigen::Vector3d>> LandmarksOf(const StereoGeometry& rig,
                                                        const Keyframe& keyframe);

/// Where the left camera sees a point [m, in the body's frame]; nothing outside its image.
std::optional<Eigen::Vector2d> PixelInLeft(const StereoGeometry& rig, const Eigen::Vector3d& p_I);

}  // namespace drydock::svin2
