#include "estimator/svin2/frontend/patch_template.h"

#include <Eigen/LU>
#include <cmath>
#include <cstdint>

namespace drydock::svin2 {
namespace {

constexpr int kMaxSteps = 15;
constexpr double kSmallStep = 0.01;  // [px]

// With room for the rounding of a patch's places.
bool IsInside(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  constexpr double kRoom = 1e-3;  // [px]
  return pixel.x() >= kRoom && pixel.y() >= kRoom && pixel.x() < image.cols - 1.0 - kRoom &&
         pixel.y() < image.rows - 1.0 - kRoom;
}

// Places in the image are counted in 2^-16 px, of which interpolation uses the first 11 bits: whole
// numbers are faster than floating point here, and products stay within 32 bits.
constexpr int kPlaceBits = 16, kShareBits = 11;

std::int32_t ToPlace(double pixels) {
  return static_cast<std::int32_t>(std::lround(std::ldexp(pixels, kPlaceBits)));
}

std::int32_t ShareOf(std::int32_t place) {
  return (place >> (kPlaceBits - kShareBits)) & ((1 << kShareBits) - 1);
}

// The grey value times 2^22.
std::int32_t Bilinear(const std::uint8_t* pixels, std::ptrdiff_t step, std::int32_t x,
                      std::int32_t y) {
  const auto* upper = pixels + (y >> kPlaceBits) * step + (x >> kPlaceBits);
  const auto* lower = upper + step;
  const std::int32_t u = ShareOf(x), v = ShareOf(y);
  const std::int32_t above = (upper[0] << kShareBits) + u * (upper[1] - upper[0]);
  const std::int32_t below = (lower[0] << kShareBits) + u * (lower[1] - lower[0]);
  return (above << kShareBits) + v * (below - above);
}

// Grey values about `centre` under the deformation, row by row; false if they leave the image.
bool Sample(const cv::Mat& image, const Eigen::Vector2d& centre, const Eigen::Matrix2d& warp,
            int radius, Eigen::VectorXf& values) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Eigen::Vector2d corner = centre + warp * Eigen::Vector2d(x * radius, y * radius);
      if (!IsInside(image, corner)) return false;
    }
  }
  constexpr float kGrey = 1.0F / (1 << 2 * kShareBits);
  const std::int32_t along_x = ToPlace(warp(0, 0)), along_y = ToPlace(warp(1, 0));
  const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(image.step);
  float* value = values.data();
  for (int row = -radius; row <= radius; ++row) {
    const Eigen::Vector2d start = centre + warp * Eigen::Vector2d(-radius, row);
    std::int32_t x = ToPlace(start.x()), y = ToPlace(start.y());
    for (int column = -radius; column <= radius; ++column, x += along_x, y += along_y)
      *value++ = kGrey * static_cast<float>(Bilinear(image.data, step, x, y));
  }
  return true;
}

}  // namespace

std::optional<PatchTemplate> PatchTemplate::Make(const cv::Mat& image, const Eigen::Vector2d& pixel,
                                                 int radius) {
  // One pixel more on each side, for the slopes.
  const int wide = 2 * radius + 3, side = 2 * radius + 1, n = side * side;
  Values around(wide * wide);
  if (!Sample(image, pixel, Eigen::Matrix2d::Identity(), radius + 1, around)) return std::nullopt;
  PatchTemplate patch;
  patch.radius_ = radius;
  patch.values_.resize(n);
  patch.slopes_.resize(kParameters, n);
  int i = 0;
  for (int row = 1; row <= side; ++row) {
    for (int column = 1; column <= side; ++column, ++i) {
      const int at = row * wide + column;
      patch.values_[i] = around[at];
      const float gx = 0.5F * (around[at + 1] - around[at - 1]);
      const float gy = 0.5F * (around[at + wide] - around[at - wide]);
      // In units of the radius, so that all entries weigh about the same.
      const float u = static_cast<float>(column - 1 - radius) / static_cast<float>(radius);
      const float v = static_cast<float>(row - 1 - radius) / static_cast<float>(radius);
      patch.slopes_.col(i) << gx, gy, 0.0F, 1.0F, gx * u, gx * v, gy * u, gy * v;
    }
  }
  patch.values_.array() -= patch.values_.mean();
  patch.slopes_.row(2) = patch.values_.transpose();
  patch.energy_ = patch.values_.squaredNorm();
  Matrix8d normal = (patch.slopes_ * patch.slopes_.transpose()).cast<double>();
  // A patch without texture in some direction cannot be located.
  const double half_sum = 0.5 * (normal(0, 0) + normal(1, 1));
  const double weakest = half_sum - std::hypot(0.5 * (normal(0, 0) - normal(1, 1)), normal(0, 1));
  if (!(weakest > 1e-3 * n)) return std::nullopt;
  patch.shift_inverse_ = normal.topLeftCorner<4, 4>().inverse();
  normal.diagonal().tail<4>().array() += 1e-6 * half_sum;
  patch.affine_inverse_ = normal.inverse();
  return patch;
}

PatchTemplate::Vector8d PatchTemplate::Step(const Values& difference, bool affine) const {
  const Vector8d right = (slopes_ * difference).cast<double>();
  if (affine) return affine_inverse_ * right;
  Vector8d step = Vector8d::Zero();
  step.head<4>() = shift_inverse_ * right.head<4>();
  return step;
}

double PatchTemplate::Correlation(const Values& found) const {
  // Ours have mean zero.
  const double energy = (found.array() - found.mean()).matrix().squaredNorm();
  return energy > 0.0 ? found.dot(values_) / std::sqrt(energy * energy_) : 0.0;
}

std::optional<PatchAlignment> PatchTemplate::Align(const cv::Mat& to, const Eigen::Vector2d& start,
                                                   const Eigen::Matrix2d& warp, bool affine) const {
  if (!start.allFinite()) return std::nullopt;
  PatchAlignment found{start, warp, 0.0};
  Values values(values_.size());
  for (int iteration = 0; iteration < kMaxSteps; ++iteration) {
    if (!Sample(to, found.pixel, found.warp, radius_, values)) return std::nullopt;
    // Brightness and contrast are solved for in full at each step: found = c * sought + b.
    const Vector8d step = Step(values - values_, affine);
    const double contrast = 1.0 + step[2];
    if (!(contrast > 0.2)) return std::nullopt;
    // The image's slopes are those of the patch times the contrast.
    const Eigen::Vector2d d = step.head<2>() / contrast;
    Eigen::Matrix2d D;
    D << step[4], step[5], step[6], step[7];
    const Eigen::Matrix2d back = (Eigen::Matrix2d::Identity() + D / (contrast * radius_)).inverse();
    // The found patch is the sought one moved by (d, D): move the other way.
    found.warp = found.warp * back;
    found.pixel -= found.warp * d;
    const double area = found.warp.determinant();
    if (!found.pixel.allFinite() || !(area > 0.1 && area < 10.0)) return std::nullopt;
    if ((found.pixel - start).norm() > radius_) return std::nullopt;
    if (d.norm() < kSmallStep) {
      // Of what was sampled before this step, which is as good as after it.
      found.correlation = Correlation(values);
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace drydock::svin2
