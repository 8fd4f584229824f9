#include "sensors_models/models/camera_model.h"

#include <Eigen/LU>
#include <array>

#include "sensors_models/models/equidistant.h"

namespace drydock {

namespace {

using Coefficients = std::array<double, 4>;

Eigen::Vector2d DistortRadtan(const Coefficients& distortion, const Eigen::Vector2d& ideal) {
  const auto [k1, k2, p1, p2] = distortion;
  const double x = ideal.x(), y = ideal.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + (k1 + k2 * r2) * r2;
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

Eigen::Matrix2d RadtanJacobian(const Coefficients& distortion, const Eigen::Vector2d& ideal) {
  const auto [k1, k2, p1, p2] = distortion;
  const double x = ideal.x(), y = ideal.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + (k1 + k2 * r2) * r2;
  const double slope = 2.0 * k1 + 4.0 * k2 * r2;  // d(radial)/d(x) = slope * x
  Eigen::Matrix2d jacobian;
  jacobian << radial + slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x,
      slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y, slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y,
      radial + slope * y * y + 6.0 * p1 * y + 2.0 * p2 * x;
  return jacobian;
}

std::optional<Eigen::Vector2d> UndistortRadtan(const Coefficients& distortion,
                                               const Eigen::Vector2d& distorted) {
  Eigen::Vector2d ideal = distorted;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Eigen::Matrix2d jacobian = RadtanJacobian(distortion, ideal);
    // Past the fold of the distortion there is no inverse.
    if (jacobian.determinant() < 1e-3) return std::nullopt;
    const Eigen::Vector2d step =
        jacobian.inverse() * (DistortRadtan(distortion, ideal) - distorted);
    ideal -= step;
    if (step.squaredNorm() < 1e-28) return ideal;
  }
  return std::nullopt;
}

}  // namespace

CameraModel::CameraModel(const CameraIntrinsics& intrinsics) : intrinsics_(intrinsics) {
  if (intrinsics.lens == LensModel::kEquidistant)
    reach_ = EquidistantLens::Reach(intrinsics.distortion);
}

Eigen::Vector2d CameraModel::Distort(const Eigen::Vector2d& ideal) const {
  return intrinsics_.lens == LensModel::kRadtan
             ? DistortRadtan(intrinsics_.distortion, ideal)
             : EquidistantLens::Distort(intrinsics_.distortion, ideal);
}

Eigen::Matrix2d CameraModel::DistortJacobian(const Eigen::Vector2d& ideal) const {
  return intrinsics_.lens == LensModel::kRadtan
             ? RadtanJacobian(intrinsics_.distortion, ideal)
             : EquidistantLens::DistortJacobian(intrinsics_.distortion, ideal);
}

Eigen::Matrix2d CameraModel::PixelByIdeal(const Eigen::Vector2d& ideal) const {
  return Eigen::Vector2d(intrinsics_.fx, intrinsics_.fy).asDiagonal() * DistortJacobian(ideal);
}

std::optional<Eigen::Vector2d> CameraModel::Project(const Eigen::Vector3d& p_C) const {
  constexpr double kNearest = 1e-6;
  if (p_C.z() < kNearest) return std::nullopt;
  const Eigen::Vector2d distorted = Distort(p_C.head<2>() / p_C.z());
  return Eigen::Vector2d(intrinsics_.fx * distorted.x() + intrinsics_.cx,
                         intrinsics_.fy * distorted.y() + intrinsics_.cy);
}

std::optional<ProjectedPoint> CameraModel::ProjectWithJacobian(const Eigen::Vector3d& p_C) const {
  const std::optional<Eigen::Vector2d> pixel = Project(p_C);
  if (!pixel) return std::nullopt;
  const Eigen::Vector2d ideal = p_C.head<2>() / p_C.z();
  Eigen::Matrix<double, 2, 3> ideal_by_point;
  ideal_by_point << 1.0, 0.0, -ideal.x(), 0.0, 1.0, -ideal.y();
  ideal_by_point /= p_C.z();
  const Eigen::Vector2d focal(intrinsics_.fx, intrinsics_.fy);
  return ProjectedPoint{*pixel, focal.asDiagonal() * (DistortJacobian(ideal) * ideal_by_point)};
}

std::optional<Eigen::Vector2d> CameraModel::Unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d distorted((pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                                  (pixel.y() - intrinsics_.cy) / intrinsics_.fy);
  return intrinsics_.lens == LensModel::kRadtan
             ? UndistortRadtan(intrinsics_.distortion, distorted)
             : EquidistantLens::Undistort(intrinsics_.distortion, reach_, distorted);
}

bool CameraModel::IsInside(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= intrinsics_.width - 0.5 &&
         pixel.y() <= intrinsics_.height - 0.5;
}

}  // namespace drydock
