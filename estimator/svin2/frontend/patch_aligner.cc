#include "estimator/svin2/frontend/patch_aligner.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <cstdint>
#include <vector>

namespace drydock::svin2 {
namespace {

// Shift x, y; its change with x and y (four entries); contrast; brightness.
constexpr int kParameters = 8;
using Vector8d = Eigen::Matrix<double, kParameters, 1>;
using Matrix8d = Eigen::Matrix<double, kParameters, kParameters>;

bool IsInside(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < image.cols - 1.0 &&
         pixel.y() < image.rows - 1.0;
}

double Bilinear(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
  const double u = pixel.x() - x, v = pixel.y() - y;
  const auto* upper = image.ptr<std::uint8_t>(y) + x;
  const auto* lower = image.ptr<std::uint8_t>(y + 1) + x;
  return (1.0 - v) * ((1.0 - u) * upper[0] + u * upper[1]) +
         v * ((1.0 - u) * lower[0] + u * lower[1]);
}

// What stays the same while the patch is sought.
struct Template {
  std::vector<double> values;  // Grey, less their mean.
  std::vector<Vector8d> jacobians;
  Eigen::LDLT<Matrix8d> normal;
  double energy = 0.0;  // Sum of the squared values.
};

std::optional<Template> MakeTemplate(const cv::Mat& image, const Eigen::Vector2d& centre,
                                     int radius, bool affine) {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(radius + 1);
  if (!IsInside(image, centre - reach) || !IsInside(image, centre + reach)) return std::nullopt;
  const int side = 2 * radius + 1;
  Template result;
  result.values.reserve(side * side);
  result.jacobians.reserve(side * side);
  double sum = 0.0;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      result.values.push_back(Bilinear(image, centre + Eigen::Vector2d(x, y)));
      sum += result.values.back();
    }
  }
  for (double& value : result.values) value -= sum / (side * side);
  Matrix8d normal = Matrix8d::Zero();
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const Eigen::Vector2d p = centre + Eigen::Vector2d(x, y);
      const double gx = 0.5 * (Bilinear(image, p + Eigen::Vector2d::UnitX()) -
                               Bilinear(image, p - Eigen::Vector2d::UnitX()));
      const double gy = 0.5 * (Bilinear(image, p + Eigen::Vector2d::UnitY()) -
                               Bilinear(image, p - Eigen::Vector2d::UnitY()));
      const double value = result.values[result.jacobians.size()];
      // In units of the radius, so that all entries weigh about the same.
      const double u = affine ? static_cast<double>(x) / radius : 0.0;
      const double v = affine ? static_cast<double>(y) / radius : 0.0;
      Vector8d jacobian;
      jacobian << gx, gy, gx * u, gx * v, gy * u, gy * v, value, 1.0;
      result.jacobians.push_back(jacobian);
      normal += jacobian * jacobian.transpose();
      result.energy += value * value;
    }
  }
  if (!affine) normal.diagonal().segment<4>(2).setOnes();
  // A patch without texture in some direction cannot be located.
  const double half_sum = 0.5 * (normal(0, 0) + normal(1, 1));
  const double weakest = half_sum - std::hypot(0.5 * (normal(0, 0) - normal(1, 1)), normal(0, 1));
  if (!(weakest > 1e-3 * side * side)) return std::nullopt;
  normal.diagonal().segment<4>(2).array() += 1e-6 * half_sum;
  result.normal.compute(normal);
  return result;
}

// Grey values of `to` under the deformation; false if it leaves the image.
bool Sample(const cv::Mat& to, const Eigen::Vector2d& shift, const Eigen::Matrix2d& A, int radius,
            std::vector<double>& values) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      if (!IsInside(to, shift + A * Eigen::Vector2d(x * radius, y * radius))) return false;
    }
  }
  values.clear();
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      values.push_back(Bilinear(to, shift + A * Eigen::Vector2d(x, y)));
    }
  }
  return true;
}

double Correlation(const Template& sought, const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0, product = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    squares += values[i] * values[i];
    product += values[i] * sought.values[i];  // These have mean zero.
  }
  const double energy = squares - sum * sum / static_cast<double>(values.size());
  return energy > 0.0 ? product / std::sqrt(energy * sought.energy) : 0.0;
}

}  // namespace

std::optional<PatchAlignment> AlignPatch(const cv::Mat& from, const Eigen::Vector2d& pixel,
                                         const cv::Mat& to, const Eigen::Vector2d& start,
                                         int radius, bool affine) {
  const auto sought = MakeTemplate(from, pixel, radius, affine);
  if (!sought.has_value()) return std::nullopt;
  Eigen::Vector2d shift = start;
  Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  std::vector<double> values;
  values.reserve(sought->values.size());
  // Brightness and contrast are solved for in full at each step: found = c * sought + b.
  for (int iteration = 0; iteration < 10; ++iteration) {
    if (!Sample(to, shift, A, radius, values)) return std::nullopt;
    Vector8d right = Vector8d::Zero();
    for (std::size_t i = 0; i < values.size(); ++i) {
      right += (values[i] - sought->values[i]) * sought->jacobians[i];
    }
    const Vector8d step = sought->normal.solve(right);
    const double contrast = 1.0 + step[6];
    if (!(contrast > 0.2)) return std::nullopt;
    // The image's slopes are those of the patch times the contrast.
    const Eigen::Vector2d d = step.head<2>() / contrast;
    Eigen::Matrix2d D;
    D << step[2], step[3], step[4], step[5];
    const Eigen::Matrix2d inverse =
        (Eigen::Matrix2d::Identity() + D / (contrast * radius)).inverse();
    if (!(std::abs(inverse.determinant() - 1.0) < 0.8)) return std::nullopt;
    // The found patch is the sought one moved by (d, D): move the other way.
    A = A * inverse;
    shift -= A * d;
    if (d.norm() < 0.01) {
      if (!Sample(to, shift, A, radius, values)) return std::nullopt;
      return PatchAlignment{shift, Correlation(*sought, values)};
    }
    if (!shift.allFinite() || (shift - start).norm() > radius) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace drydock::svin2
