#include "estimator/svin2/frontend/stereo_geometry.h"

#include <Eigen/LU>
#include <cmath>

namespace drydock::svin2 {
namespace {

// The line that `normal` cuts out of z = 1, as a normal in pixels of `camera` about `ideal`.
Eigen::Vector2d AcrossLine(const CameraModel& camera, const Eigen::Vector2d& ideal,
                           const Eigen::Vector3d& normal) {
  // What a radtan lens changes of it is some per cent; a fisheye's border is shrunk several times.
  if (camera.intrinsics().lens == LensModel::kEquidistant)
    return camera.PixelByIdeal(ideal).inverse().transpose() * normal.head<2>();
  return {normal.x() / camera.intrinsics().fx, normal.y() / camera.intrinsics().fy};
}

}  // namespace

std::optional<double> EpipolarDistance(const CameraModel& a, const Eigen::Vector2d& pixel_a,
                                       const CameraModel& b, const Eigen::Vector2d& pixel_b,
                                       const Pose& T_BA) {
  const auto ideal_a = a.Unproject(pixel_a);
  const auto ideal_b = b.Unproject(pixel_b);
  if (!ideal_a.has_value() || !ideal_b.has_value()) return std::nullopt;
  // The plane of both centres and the ray, as its normal in b; it cuts z = 1 in the line.
  const Eigen::Vector3d normal = T_BA.p().cross(T_BA.q() * ideal_a->homogeneous());
  const double length = normal.head<2>().norm();
  if (!(length > 1e-9 * T_BA.p().norm())) return std::nullopt;
  return std::abs(normal.dot(ideal_b->homogeneous())) / AcrossLine(b, *ideal_b, normal).norm();
}

StereoGeometry::StereoGeometry(const StereoSheet& sheet)
    : cameras_{CameraModel(sheet.cameras[0]), CameraModel(sheet.cameras[1])},
      T_IC_(sheet.T_IC),
      T_C1C0_(sheet.T_IC[1].Inverse() * sheet.T_IC[0]) {}

std::optional<double> StereoGeometry::EpipolarDistance(const Eigen::Vector2d& left,
                                                       const Eigen::Vector2d& right) const {
  return svin2::EpipolarDistance(cameras_[0], left, cameras_[1], right, T_C1C0_);
}

std::optional<Eigen::Vector2d> StereoGeometry::Transfer(const Eigen::Vector2d& left,
                                                        double inverse_depth) const {
  const auto ideal = cameras_[0].Unproject(left);
  if (!ideal.has_value()) return std::nullopt;
  // The point times its inverse depth: the same pixel, and infinity is no exception.
  return cameras_[1].Project(T_C1C0_.q() * ideal->homogeneous() + inverse_depth * T_C1C0_.p());
}

std::optional<double> StereoGeometry::InverseDepth(const Eigen::Vector2d& left,
                                                   const Eigen::Vector2d& right) const {
  const auto ideal_left = cameras_[0].Unproject(left);
  const auto ideal_right = cameras_[1].Unproject(right);
  if (!ideal_left.has_value() || !ideal_right.has_value()) return std::nullopt;
  // right = (ray + w t) / z of it, in x and y: two equations that are linear in w.
  const Eigen::Vector3d ray = T_C1C0_.q() * ideal_left->homogeneous();
  const Eigen::Vector3d& t = T_C1C0_.p();
  const Eigen::Vector2d by_w = *ideal_right * t.z() - t.head<2>();
  const Eigen::Vector2d at_infinity = ray.head<2>() - *ideal_right * ray.z();
  if (!(by_w.squaredNorm() > 0.0)) return std::nullopt;
  return by_w.dot(at_infinity) / by_w.squaredNorm();
}

}  // namespace drydock::svin2
