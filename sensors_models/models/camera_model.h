// A pinhole camera behind a radial-tangential or an equidistant lens.
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
/// cv::projectPoints for a radtan lens (k1, k2, p1, p2), with cv::fisheye::projectPoints for an
/// equidistant one (k1 to k4).
class CameraModel {
 public:
  explicit CameraModel(const CameraIntrinsics& intrinsics);

  const CameraIntrinsics& intrinsics() const { return intrinsics_; }

  /// The pixel of `p_C` [m, in C], inside the image or not; nothing for points at or behind the
  /// camera's plane.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;

  /// The same with its derivative.
  std::optional<ProjectedPoint> ProjectWithJacobian(const Eigen::Vector3d& p_C) const;

  /// The point on the plane z = 1 of C that `pixel` sees; nothing where the distortion cannot be
  /// inverted, or where an equidistant lens looks more than EquidistantLens::kWidest off its axis.
  std::optional<Eigen::Vector2d> Unproject(const Eigen::Vector2d& pixel) const;

  /// d(pixel) / d(ideal) at a point of the plane z = 1 of C [px].
  Eigen::Matrix2d PixelByIdeal(const Eigen::Vector2d& ideal) const;

  /// Pixel centres from 0 to size - 1, each widened by half a pixel.
  bool IsInside(const Eigen::Vector2d& pixel) const;

 private:
  Eigen::Vector2d Distort(const Eigen::Vector2d& ideal) const;
  Eigen::Matrix2d DistortJacobian(const Eigen::Vector2d& ideal) const;

  CameraIntrinsics intrinsics_;
  double reach_ = 0.0;  // Of an equidistant lens.
};

}  // namespace drydock
