#include "estimator/svin2/frontend/corner_detector.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

// Which points lie within a radius of one already taken: buckets as wide as the radius, so that
// only a point's own bucket and the eight about it need a look.
class Occupancy {
 public:
  Occupancy(const cv::Size& size, double radius)
      : radius_(std::max(radius, 1.0)),
        columns_(static_cast<int>(size.width / radius_) + 1),
        rows_(static_cast<int>(size.height / radius_) + 1),
        buckets_(static_cast<std::size_t>(columns_) * rows_) {}

  bool IsFree(const Eigen::Vector2d& pixel) const {
    const int column = Column(pixel), row = Row(pixel);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r) {
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
        for (const Eigen::Vector2d& other : buckets_[r * columns_ + c]) {
          if ((other - pixel).squaredNorm() < radius_ * radius_) return false;
        }
      }
    }
    return true;
  }

  void Take(const Eigen::Vector2d& pixel) {
    buckets_[Row(pixel) * columns_ + Column(pixel)].push_back(pixel);
  }

 private:
  // Points outside the image count in the buckets at its edge.
  int Column(const Eigen::Vector2d& pixel) const {
    return static_cast<int>(std::clamp(pixel.x() / radius_, 0.0, columns_ - 1.0));
  }
  int Row(const Eigen::Vector2d& pixel) const {
    return static_cast<int>(std::clamp(pixel.y() / radius_, 0.0, rows_ - 1.0));
  }

  double radius_;
  int columns_, rows_;
  std::vector<std::vector<Eigen::Vector2d>> buckets_;
};

// A point near `pixel` where the edges in the window meet, or about which they run in circles:
// each tangent (or normal) of an edge should pass through it. Nothing if the window leaves the
// image or has no such point.
std::optional<Eigen::Vector2d> FitPoint(const cv::Mat& image, const Eigen::Vector2d& pixel,
                                        int radius) {
  const int x0 = static_cast<int>(std::lround(pixel.x()));
  const int y0 = static_cast<int>(std::lround(pixel.y()));
  if (x0 <= radius || y0 <= radius || x0 >= image.cols - radius - 1 ||
      y0 >= image.rows - radius - 1) {
    return std::nullopt;
  }
  const Eigen::Vector2d from = pixel - Eigen::Vector2d(x0, y0);
  // The junction minimises sum (g . (p - q))^2, with g across the edge; the centre has g along it.
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero(), along = Eigen::Matrix2d::Zero();
  Eigen::Vector2d across_p = Eigen::Vector2d::Zero(), along_p = Eigen::Vector2d::Zero();
  double across_pp = 0.0, along_pp = 0.0;
  for (int y = y0 - radius; y <= y0 + radius; ++y) {
    const auto* above = image.ptr<std::uint8_t>(y - 1);
    const auto* here = image.ptr<std::uint8_t>(y);
    const auto* below = image.ptr<std::uint8_t>(y + 1);
    for (int x = x0 - radius; x <= x0 + radius; ++x) {
      const Eigen::Vector2d p(x - x0, y - y0);
      const double weight = std::exp(-2.0 * (p - from).squaredNorm() / (radius * radius));
      const Eigen::Vector2d g(here[x + 1] - here[x - 1], below[x] - above[x]);
      const Eigen::Vector2d t(-g.y(), g.x());
      across += weight * g * g.transpose();
      across_p += weight * g * g.dot(p);
      across_pp += weight * g.dot(p) * g.dot(p);
      along += weight * t * t.transpose();
      along_p += weight * t * t.dot(p);
      along_pp += weight * t.dot(p) * t.dot(p);
    }
  }
  if (across.determinant() < 1e-3 * across.trace() * across.trace()) return std::nullopt;
  const Eigen::Vector2d junction = across.inverse() * across_p;
  const Eigen::Vector2d centre = along.inverse() * along_p;
  const bool is_junction = across_pp - across_p.dot(junction) <= along_pp - along_p.dot(centre);
  return Eigen::Vector2d(x0, y0) + (is_junction ? junction : centre);
}

}  // namespace

CornerDetector::CornerDetector(const Config& config) : config_(config) {
  RequireInput(config.max_corners > 0, "max_corners is {}; it must be positive",
               config.max_corners);
  RequireInput(config.radius_px >= 1.0, "radius_px is {}; it must be at least 1", config.radius_px);
  RequireInput(config.window_sigma_px > 0.0 && config.window_sigma_px <= 5.0,
               "window_sigma_px is {}; it must lie in (0, 5]", config.window_sigma_px);
  RequireInput(config.refine_radius_px >= 0 && config.border_px > config.refine_radius_px,
               "border_px is {} and refine_radius_px {}; the border must be the larger",
               config.border_px, config.refine_radius_px);
}

cv::Mat CornerDetector::Scores(const cv::Mat& image) const {
  cv::Mat dx, dy;
  // Scharr's smoothing weighs 3, 10, 3; a step of 2 px between the arms.
  constexpr double kUnits = 1.0 / (2.0 * 16.0 * 255.0);
  cv::Scharr(image, dx, CV_32F, 1, 0, kUnits);
  cv::Scharr(image, dy, CV_32F, 0, 1, kUnits);
  std::array<cv::Mat, 3> tensor = {dx.mul(dx), dx.mul(dy), dy.mul(dy)};
  const int radius = static_cast<int>(std::ceil(2.0 * config_.window_sigma_px));
  for (cv::Mat& entry : tensor) {
    cv::GaussianBlur(entry, entry, {2 * radius + 1, 2 * radius + 1}, config_.window_sigma_px);
  }
  cv::Mat scores(image.size(), CV_32F);
  for (int row = 0; row < image.rows; ++row) {
    const auto* xx = tensor[0].ptr<float>(row);
    const auto* xy = tensor[1].ptr<float>(row);
    const auto* yy = tensor[2].ptr<float>(row);
    auto* score = scores.ptr<float>(row);
    for (int column = 0; column < image.cols; ++column) {
      const float half_sum = 0.5F * (xx[column] + yy[column]);
      const float half_difference = 0.5F * (xx[column] - yy[column]);
      score[column] =
          half_sum - std::sqrt(half_difference * half_difference + xy[column] * xy[column]);
    }
  }
  return scores;
}

std::vector<Corner> CornerDetector::Candidates(const cv::Mat& scores, const cv::Mat& mask) const {
  const int border = config_.border_px;
  if (scores.cols <= 2 * border || scores.rows <= 2 * border) return {};
  cv::Mat highest;
  cv::dilate(scores, highest, cv::Mat());
  double strongest = 0.0;
  cv::minMaxLoc(scores, nullptr, &strongest);
  const auto least =
      static_cast<float>(std::max(config_.min_score, config_.min_quality * strongest));
  std::vector<Corner> candidates;
  for (int row = border; row < scores.rows - border; ++row) {
    const auto* here = scores.ptr<float>(row);
    const auto* highest_here = highest.ptr<float>(row);
    const auto* allowed = mask.empty() ? nullptr : mask.ptr<std::uint8_t>(row);
    for (int column = border; column < scores.cols - border; ++column) {
      if (here[column] < least || here[column] < highest_here[column]) continue;
      if (allowed != nullptr && allowed[column] == 0) continue;
      candidates.push_back({Eigen::Vector2d(column, row), here[column]});
    }
  }
  // Stable: equal scores stay in the order of the scan.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Corner& a, const Corner& b) { return a.score > b.score; });
  return candidates;
}

Eigen::Vector2d CornerDetector::Refined(const cv::Mat& image, const Eigen::Vector2d& pixel) const {
  Eigen::Vector2d refined = pixel;
  // Again about the point found: edges that the window misses pull it aside.
  for (int iteration = 0; iteration < 5; ++iteration) {
    const auto fitted = FitPoint(image, refined, config_.refine_radius_px);
    if (!fitted.has_value() || (*fitted - pixel).norm() > config_.max_refine_px) return pixel;
    const bool is_there = (*fitted - refined).norm() < 0.02;
    refined = *fitted;
    if (is_there) break;
  }
  return refined;
}

std::vector<Corner> CornerDetector::Detect(const cv::Mat& image,
                                           const std::vector<Eigen::Vector2d>& occupied,
                                           const cv::Mat& mask) const {
  Check(image.type() == CV_8UC1 && !image.empty(), "corners need an image of type CV_8UC1");
  Check(mask.empty() || (mask.type() == CV_8UC1 && mask.size() == image.size()),
        "a mask must be CV_8UC1 and of the image's size");
  Occupancy occupancy(image.size(), config_.radius_px);
  for (const Eigen::Vector2d& pixel : occupied) occupancy.Take(pixel);
  const int budget = config_.max_corners - static_cast<int>(occupied.size());
  const cv::Mat scores = Scores(image);
  std::vector<Corner> corners;
  for (const Corner& candidate : Candidates(scores, mask)) {
    if (static_cast<int>(corners.size()) >= budget) break;
    if (!occupancy.IsFree(candidate.pixel)) continue;
    occupancy.Take(candidate.pixel);
    corners.push_back(candidate);
    if (config_.refine_radius_px > 0) corners.back().pixel = Refined(image, candidate.pixel);
  }
  return corners;
}

}  // namespace drydock::svin2
