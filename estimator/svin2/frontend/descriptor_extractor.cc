#include "estimator/svin2/frontend/descriptor_extractor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {

namespace {

constexpr std::size_t kBits = 512;

struct Circle {
  double radius;  // In the paper's units.
  int samples;
};
constexpr std::array<Circle, 5> kCircles = {
    {{0.0, 1}, {2.9, 10}, {4.9, 14}, {7.4, 15}, {10.8, 20}}};

// The integral of the image from its corner to (x, y), where pixel (i, j) fills the unit square
// from (i, j) on. An image of constant squares has an integral that is bilinear between corners.
double Integral(const cv::Mat& integral, double x, double y) {
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const double u = x - i, v = y - j;
  const auto* upper = integral.ptr<std::int32_t>(j) + i;
  const auto* lower = integral.ptr<std::int32_t>(j + 1) + i;
  return (1.0 - v) * ((1.0 - u) * upper[0] + u * upper[1]) +
         v * ((1.0 - u) * lower[0] + u * lower[1]);
}

double BoxMean(const cv::Mat& integral, const Eigen::Vector2d& pixel, double half_width) {
  // Pixel centres lie on integers, its square begins half a pixel before.
  const double x = pixel.x() + 0.5, y = pixel.y() + 0.5, h = half_width;
  return (Integral(integral, x + h, y + h) - Integral(integral, x - h, y + h) -
          Integral(integral, x + h, y - h) + Integral(integral, x - h, y - h)) /
         (4.0 * h * h);
}

}  // namespace

std::optional<double> GravityAngle(const CameraModel& camera, const Eigen::Vector2d& pixel,
                                   const Eigen::Vector3d& gravity_C) {
  const auto ideal = camera.Unproject(pixel);
  const double length = gravity_C.norm();
  if (!ideal.has_value() || !(length > 0.0)) return std::nullopt;
  // The derivative by differences, so that the lens's distortion is in it.
  constexpr double kStep = 1e-3;
  const Eigen::Vector3d step = kStep / length * gravity_C;
  const auto below = camera.Project(ideal->homogeneous() + step);
  const auto above = camera.Project(ideal->homogeneous() - step);
  if (!below.has_value() || !above.has_value()) return std::nullopt;
  const Eigen::Vector2d direction = *below - *above;
  // Within 3 degrees of gravity its direction turns too fast to be of use.
  if (direction.norm() < 0.05 * 2.0 * kStep * camera.intrinsics().fx) return std::nullopt;
  return std::atan2(direction.y(), direction.x());
}

DescriptorExtractor::DescriptorExtractor(const Config& config) {
  RequireInput(config.pattern_radius_px >= 5.0 && config.pattern_radius_px <= 100.0,
               "pattern_radius_px is {}; it must lie in [5, 100]", config.pattern_radius_px);
  const double scale = config.pattern_radius_px / kCircles.back().radius;
  for (const Circle& circle : kCircles) {
    // The spacing of a circle's samples sets their smoothing; the middle has one of its own.
    const double sigma = circle.samples == 1
                             ? 0.65
                             : 1.3 * circle.radius * std::sin(std::numbers::pi / circle.samples);
    for (int i = 0; i < circle.samples; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / circle.samples;
      samples_.push_back({scale * circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                          scale * std::sqrt(3.0) * sigma});
      reach_px_ = std::max(reach_px_,
                           samples_.back().at.norm() + std::sqrt(2.0) * samples_.back().half_width);
    }
  }
  for (std::size_t a = 1; a < samples_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      pairs_.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
    }
  }
  // Distances that are equal but for rounding must fall in the same order on every machine.
  const auto length = [this, scale](const Pair& pair) {
    return std::llround(1e6 / scale * (samples_[pair.a].at - samples_[pair.b].at).norm());
  };
  std::stable_sort(pairs_.begin(), pairs_.end(), [&length](const Pair& left, const Pair& right) {
    return length(left) < length(right);
  });
  pairs_.resize(kBits);
}

std::vector<std::optional<Descriptor>> DescriptorExtractor::Describe(
    const cv::Mat& image, const std::vector<Eigen::Vector2d>& pixels, const CameraModel& camera,
    const Eigen::Vector3d& gravity_C, double scale) const {
  Check(image.type() == CV_8UC1 && !image.empty(), "descriptors need an image of type CV_8UC1");
  cv::Mat integral;
  cv::integral(image, integral, CV_32S);
  std::vector<std::optional<Descriptor>> descriptors(pixels.size());
  std::array<double, 64> brightness{};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::Vector2d pixel = pixels[i] / scale;
    const bool fits = pixel.x() >= reach_px_ && pixel.y() >= reach_px_ &&
                      pixel.x() <= image.cols - 1 - reach_px_ &&
                      pixel.y() <= image.rows - 1 - reach_px_;
    const auto angle = fits ? GravityAngle(camera, pixels[i], gravity_C) : std::nullopt;
    if (!angle.has_value()) continue;
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(*angle).toRotationMatrix();
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      brightness[s] = BoxMean(integral, pixel + R * samples_[s].at, samples_[s].half_width);
    }
    Descriptor& descriptor = descriptors[i].emplace();
    descriptor.fill(0);
    for (std::size_t bit = 0; bit < pairs_.size(); ++bit) {
      const bool brighter = brightness[pairs_[bit].a] > brightness[pairs_[bit].b];
      descriptor[bit / 64] |= static_cast<std::uint64_t>(brighter) << (bit % 64);
    }
  }
  return descriptors;
}

}  // namespace drydock::svin2
