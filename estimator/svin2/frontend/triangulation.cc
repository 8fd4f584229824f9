#include "estimator/svin2/frontend/triangulation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace drydock::svin2 {
namespace {

struct Ray {
  Eigen::Vector3d direction_W;  // Of length 1.
  Eigen::Vector2d ideal;        // On the plane z = 1 of C.
  Eigen::Matrix2d information;  // Of `ideal`.
};

// How the pixel's uncertainty looks on the plane z = 1, by differences: the lens's distortion is
// in it.
std::optional<Ray> MakeRay(const View& view) {
  const auto ideal = view.camera->Unproject(view.pixel);
  if (!ideal.has_value()) return std::nullopt;
  constexpr double kStep = 1e-4;
  Eigen::Matrix2d pixel_by_ideal;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const auto plus = view.camera->Project(ideal->homogeneous() + step);
    const auto minus = view.camera->Project(ideal->homogeneous() - step);
    if (!plus.has_value() || !minus.has_value()) return std::nullopt;
    pixel_by_ideal.col(i) = (*plus - *minus) / (2.0 * kStep);
  }
  return Ray{(view.T_WC.q() * ideal->homogeneous()).normalized(), *ideal,
             pixel_by_ideal.transpose() * pixel_by_ideal / (view.sigma_px * view.sigma_px)};
}

double LargestAngle(const std::vector<Ray>& rays) {
  double largest = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3d& a = rays[i].direction_W;
      const Eigen::Vector3d& b = rays[j].direction_W;
      largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return largest;
}

// Least sum of squared distances to the rays.
Eigen::Vector3d NearestToRays(const std::vector<View>& views, const std::vector<Ray>& rays) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Vector3d& d = rays[i].direction_W;
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    A += across;
    b += across * views[i].T_WC.p();
  }
  return A.ldlt().solve(b);
}

struct Normal {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double max_chi2 = 0.0;
  double min_depth = 0.0, max_depth = 0.0;
};

// Nothing if the point lies behind a camera.
std::optional<Normal> Linearise(const std::vector<View>& views, const std::vector<Ray>& rays,
                                const Eigen::Vector3d& p_W) {
  Normal normal;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Matrix3d R_CW = views[i].T_WC.R().transpose();
    const Eigen::Vector3d p_C = R_CW * (p_W - views[i].T_WC.p());
    if (p_C.z() <= 1e-6) return std::nullopt;
    const Eigen::Vector2d predicted = p_C.head<2>() / p_C.z();
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << Eigen::Matrix2d::Identity(), -predicted;
    jacobian = (jacobian / p_C.z() * R_CW).eval();
    const Eigen::Vector2d error = rays[i].ideal - predicted;
    const Eigen::Matrix2d& information = rays[i].information;
    normal.information += jacobian.transpose() * information * jacobian;
    normal.right += jacobian.transpose() * information * error;
    normal.max_chi2 = std::max(normal.max_chi2, error.dot(information * error));
    normal.min_depth = i == 0 ? p_C.z() : std::min(normal.min_depth, p_C.z());
    normal.max_depth = std::max(normal.max_depth, p_C.z());
  }
  return normal;
}

}  // namespace

Triangulation Triangulate(const std::vector<View>& views, const TriangulationConfig& config) {
  Triangulation result;
  std::vector<Ray> rays;
  for (const View& view : views) {
    const auto ray = MakeRay(view);
    if (!ray.has_value()) return result;
    rays.push_back(*ray);
  }
  result.parallax_rad = LargestAngle(rays);
  result.status = TriangulationStatus::kLowParallax;
  // Without any parallax there is no point at all.
  if (rays.size() < 2 || !(result.parallax_rad >= std::max(config.min_parallax_rad, 1e-6))) {
    return result;
  }
  result.status = TriangulationStatus::kOutOfRange;
  result.p_W = NearestToRays(views, rays);
  std::optional<Normal> normal = Linearise(views, rays, result.p_W);
  for (int iteration = 0; iteration < 5 && normal.has_value(); ++iteration) {
    const Eigen::Vector3d step = normal->information.ldlt().solve(normal->right);
    if (!step.allFinite()) return result;
    result.p_W += step;
    normal = Linearise(views, rays, result.p_W);
    if (step.norm() < 1e-9 * (result.p_W - views[0].T_WC.p()).norm()) break;
  }
  if (!normal.has_value()) return result;
  result.covariance = normal->information.inverse();
  result.max_chi2 = normal->max_chi2;
  if (normal->min_depth < config.min_depth_m || normal->max_depth > config.max_depth_m) {
    return result;
  }
  result.status = result.max_chi2 <= config.max_chi2 ? TriangulationStatus::kGood
                                                     : TriangulationStatus::kHighChi2;
  return result;
}

}  // namespace drydock::svin2
