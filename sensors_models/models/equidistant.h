// The equidistant lens: a polynomial in the angle off the axis.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace drydock {

/// The fisheye of Kannala and Brandt (PAMI 2006), as cv::fisheye and Kalibr have it. A ray at the
/// angle t off the axis meets the plane z = 1 at the radius tan t; the lens moves it there, along
/// the same radius, to
///
///     b(t) = t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8)
///
/// Without coefficients, equal angles are equally long.
class EquidistantLens {
 public:
  /// k1 to k4.
  using Coefficients = std::array<double, 4>;

  /// Rays further off the axis [rad] have no point on z = 1 that could be computed with: there it
  /// is 11 times as far from the axis as from the camera. 85 degrees.
  static constexpr double kWidest = 1.4835298641951802;

  /// Where the lens moves a point of z = 1. Any point: b() is taken beyond kWidest, too.
  static Eigen::Vector2d Distort(const Coefficients& k, const Eigen::Vector2d& ideal);
  /// d(Distort) / d(ideal).
  static Eigen::Matrix2d DistortJacobian(const Coefficients& k, const Eigen::Vector2d& ideal);
  /// The angle [rad] up to which pixels have a ray: kWidest or, before that, where b() stops to
  /// rise: there the lens folds over.
  static double Reach(const Coefficients& k);
  /// The inverse of Distort within `reach`, which is Reach(k); nothing beyond it.
  static std::optional<Eigen::Vector2d> Undistort(const Coefficients& k, double reach,
                                                  const Eigen::Vector2d& distorted);
};

}  // namespace drydock
