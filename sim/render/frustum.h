// What a view can see of the world: bodies outside its pyramid need not be drawn.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sensors_models/base/pose.h"
#include "sim/render/pinhole.h"

namespace drydock::sim {

/// The corners of a box, one a column [m, in W].
using BoxCorners = Eigen::Matrix<double, 3, 8>;

/// The box around `centre` with these half sizes along the columns of `R` [m].
BoxCorners CornersOfBox(const Eigen::Vector3d& centre, const Eigen::Matrix3d& R,
                        const Eigen::Vector3d& half_sizes);

/// The pyramid that a pinhole at `T_WC` sees, its pixels in full, between the depths `near` and
/// `far` [m].
class Frustum {
 public:
  Frustum(const Pose& T_WC, const Pinhole& pinhole, double near, double far);

  /// The depth of the box's farthest corner [m], nothing if all of the box lies outside one of the
  /// pyramid's faces. (A box off a corner of the pyramid may pass though it is not seen.)
  std::optional<double> FarthestDepth(const BoxCorners& box) const;

 private:
  Pose T_CW_;
  double near_;
  double far_;
  /// Normals of the four side faces, which meet in the camera, one a row, in C; inside is positive.
  Eigen::Matrix<double, 4, 3> sides_;
};

}  // namespace drydock::sim
