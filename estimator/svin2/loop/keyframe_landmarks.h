// Where the points of a keyframe are.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/loop/keyframe.h"

namespace drydock::svin2 {

/// Finds by stereo where those points are that both eyes saw and the window has not estimated.
void TriangulateByStereo(const StereoGeometry& rig, Keyframe& keyframe);

/// Where the left camera sees a point [m, in the body's frame]; nothing outside its image.
std::optional<Eigen::Vector2d> PixelInLeft(const StereoGeometry& rig, const Eigen::Vector3d& p_I);

}  // namespace drydock::svin2
