// What lights things that float in the water.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace drydock::sim {

/// The radiance of a small white ball at `p_W` [m, in W], the mean over its disc, per channel (red,
/// green, blue), without the water between it and the camera. Radiance 1 is that of a white card
/// that lies flat under the full sun at the surface. A matt ball has a quarter of what such a card
/// that faces a beam has (the mean over all directions of view), two thirds where the lamp is
/// beside the camera, and 0.625 of what a flat one has under diffuse daylight.
using LightAt = std::function<Eigen::Array3f(const Eigen::Vector3d& p_W)>;

}  // namespace drydock::sim
