// A pinhole camera with radial-tangential distortion.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sensors_models/measurement/rig.h"

namespace drydock {

/// A pixel and how it moves with the point that it shows.
struct ProjectedPoint {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> by_point;  ///< d(pixel) / d(p_C) [px/m].
};

/// Maps points in the camera frame C (x right, y down, z forward) to pixels and back. Agrees with
/// cv::projectPoints for the distortion (k1, k2, p1, p2).
class CameraModel {
 public:
  explicit CameraModel(const CameraIntrinsics& intrinsics) : intrinsics_(intrinsics) {}

  const CameraIntrinsics& intrinsics() const { return intrinsics_; }

  /// The pixel of `p_C` [m, in C], inside the image or not; nothing for points at or behind the
  /// camera's plane.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;

  /// The same with its derivative.
  std::optional<ProjectedPoint> ProjectWithJacobian(const Eigen::Vector3d& p_C) const;

  /// The point on the plane z = 1 of C that `pixel` sees; nothing where the distortion cannot be
  /// inverted.
  std::optional<Eigen::Vector2d> Unproject(const Eigen::Vector2d& pixel) const;

  /// Pixel centres from 0 to size - 1, each widened by half a pixel.
  bool IsInside(const Eigen::Vector2d& pixel) const;

 private:
  Eigen::Vector2d Distort(const Eigen::Vector2d& ideal) const;
  Eigen::Matrix2d DistortJacobian(const Eigen::Vector2d& ideal) const;

  CameraIntrinsics intrinsics_;
};

}  // namespace drydock
