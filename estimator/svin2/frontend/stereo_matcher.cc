#include "estimator/svin2/frontend/stereo_matcher.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

bool HasPatch(const cv::Mat& image, const cv::Point& at, int radius) {
  return at.x >= radius && at.y >= radius && at.x < image.cols - radius &&
         at.y < image.rows - radius;
}

// Of the grey values of two square patches; 0 where one of them is blank.
double Correlation(const cv::Mat& a, const cv::Point& at_a, const cv::Mat& b, const cv::Point& at_b,
                   int radius) {
  int sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;  // Enough for a radius of 90.
  for (int y = -radius; y <= radius; ++y) {
    const auto* row_a = a.ptr<std::uint8_t>(at_a.y + y) + at_a.x;
    const auto* row_b = b.ptr<std::uint8_t>(at_b.y + y) + at_b.x;
    for (int x = -radius; x <= radius; ++x) {
      const int va = row_a[x], vb = row_b[x];
      sum_a += va;
      sum_b += vb;
      aa += va * va;
      bb += vb * vb;
      ab += va * vb;
    }
  }
  const double n = (2 * radius + 1) * (2 * radius + 1);
  const double mean_a = sum_a / n, mean_b = sum_b / n;
  const double energy_a = aa - sum_a * mean_a, energy_b = bb - sum_b * mean_b;
  if (energy_a <= 0.0 || energy_b <= 0.0) return 0.0;
  return (ab - sum_a * mean_b) / std::sqrt(energy_a * energy_b);
}

cv::Point Rounded(const Eigen::Vector2d& pixel) {
  return {static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))};
}

}  // namespace

StereoMatcher::StereoMatcher(const Config& config, const StereoGeometry& geometry,
                             const PatchTracker& tracker)
    : config_(config), geometry_(geometry), tracker_(tracker) {
  RequireInput(config.min_depth_m > 0.0, "min_depth_m is {}; it must be positive",
               config.min_depth_m);
  RequireInput(
      config.search_level >= 0 && config.search_radius_px >= 1 && config.search_radius_px <= 50,
      "search_level is {} and search_radius_px {}; at least 0 and within [1, 50]",
      config.search_level, config.search_radius_px);
}

std::optional<Eigen::Vector2d> StereoMatcher::Search(const ImagePyramid& left,
                                                     const ImagePyramid& right,
                                                     const SoughtInRight& point) const {
  const int level =
      std::min({std::max(config_.search_level, point.octave), static_cast<int>(left.size()) - 1,
                static_cast<int>(right.size()) - 1});
  const double scale = OctaveScale(level);
  const int radius = config_.search_radius_px;
  const cv::Point at_left = Rounded(point.left / scale);
  const auto nearest = geometry_.Transfer(point.left, 1.0 / config_.min_depth_m);
  const auto farthest = geometry_.Transfer(point.left, 0.0);
  if (!nearest.has_value() || !farthest.has_value() || !HasPatch(left[level], at_left, radius)) {
    return std::nullopt;
  }
  // One step a pixel of this level; pixels go nearly evenly with inverse depth.
  const int steps =
      std::clamp(static_cast<int>(std::ceil((*nearest - *farthest).norm() / scale)), 1, 1000);
  std::optional<Eigen::Vector2d> best;
  double best_correlation = config_.min_search_correlation;
  for (int step = 0; step <= steps; ++step) {
    const auto candidate = geometry_.Transfer(point.left, step / (steps * config_.min_depth_m));
    if (!candidate.has_value()) continue;
    const cv::Point at_right = Rounded(*candidate / scale);
    if (!HasPatch(right[level], at_right, radius)) continue;
    const double correlation = Correlation(left[level], at_left, right[level], at_right, radius);
    if (correlation <= best_correlation) continue;
    best_correlation = correlation;
    best = candidate;
  }
  return best;
}

bool StereoMatcher::IsOnCurve(const Eigen::Vector2d& left, const Eigen::Vector2d& right,
                              int octave) const {
  const auto distance = geometry_.EpipolarDistance(left, right);
  return distance.has_value() && *distance <= OctaveScale(octave) * config_.max_epipolar_px;
}

std::vector<PatchTrack> StereoMatcher::Match(const ImagePyramid& left, const ImagePyramid& right,
                                             const std::vector<SoughtInRight>& points) const {
  std::vector<PatchTrack> tracks(points.size());
  std::vector<Eigen::Vector2d> sought, predicted;
  std::vector<int> octaves;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SoughtInRight& point = points[i];
    const auto start = point.inverse_depth.has_value()
                           ? geometry_.Transfer(point.left, *point.inverse_depth)
                           : Search(left, right, point);
    if (!start.has_value()) continue;
    sought.push_back(point.left);
    predicted.push_back(*start);
    octaves.push_back(point.octave);
    places.push_back(i);
  }
  const auto found = tracker_.Track(left, right, sought, predicted, octaves);
  for (std::size_t i = 0; i < found.size(); ++i) {
    PatchTrack& track = tracks[places[i]];
    track = found[i];
    if (track.IsTracked() && !IsOnCurve(sought[i], track.pixel, octaves[i])) {
      track.status = TrackStatus::kOffEpipolar;
    }
  }
  return tracks;
}

}  // namespace drydock::svin2
