#include "estimator/svin2/frontend/patch_tracker.h"

#include <algorithm>
#include <cstdint>

#include <opencv2/video/tracking.hpp>

#include "estimator/svin2/frontend/patch_template.h"
#include "sensors_models/base/check.h"

namespace drydock::svin2 {
namespace {

cv::Point2f ToPoint(const Eigen::Vector2d& pixel) {
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

bool IsInside(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.cols - 1.0 &&
         pixel.y() <= image.rows - 1.0;
}

}  // namespace

PatchTracker::PatchTracker(const Config& config) : config_(config) {
  RequireInput(config.window_px >= 5 && config.window_px % 2 == 1,
               "window_px is {}; it must be odd and at least 5", config.window_px);
  RequireInput(config.levels >= 1 && config.levels <= 8, "levels is {}; it must lie in [1, 8]",
               config.levels);
  RequireInput(config.patch_radius_px >= 0 && config.patch_radius_px <= 50,
               "patch_radius_px is {}; it must lie in [0, 50]", config.patch_radius_px);
}

ImagePyramid PatchTracker::MakePyramid(const cv::Mat& image, int levels) const {
  Check(image.type() == CV_8UC1 && !image.empty(), "tracking needs an image of type CV_8UC1");
  ImagePyramid pyramid;
  // Small images end early: the pyramid then has fewer levels.
  cv::buildOpticalFlowPyramid(image, pyramid, {config_.window_px, config_.window_px}, levels - 1,
                              false);
  return pyramid;
}

std::vector<PatchTrack> PatchTracker::Track(const ImagePyramid& from, const ImagePyramid& to,
                                            const std::vector<Eigen::Vector2d>& pixels,
                                            const std::vector<Eigen::Vector2d>& predicted,
                                            const std::vector<int>& octaves) const {
  Check(pixels.size() == predicted.size(), "{} pixels but {} predictions", pixels.size(),
        predicted.size());
  Check(octaves.empty() || octaves.size() == pixels.size(), "{} pixels but {} octaves",
        pixels.size(), octaves.size());
  if (octaves.empty()) return TrackInOctave(from, to, pixels, predicted);
  std::vector<PatchTrack> tracks(pixels.size());
  const int levels = static_cast<int>(std::min(from.size(), to.size()));
  for (int octave = 0; octave < levels; ++octave) {
    const double scale = OctaveScale(octave);
    std::vector<std::size_t> places;
    std::vector<Eigen::Vector2d> start, near;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (octaves[i] != octave) continue;
      places.push_back(i);
      start.emplace_back(pixels[i] / scale);
      near.emplace_back(predicted[i] / scale);
    }
    const auto found = TrackInOctave({from.begin() + octave, from.end()},
                                     {to.begin() + octave, to.end()}, start, near);
    for (std::size_t k = 0; k < places.size(); ++k) {
      tracks[places[k]] = found[k];
      tracks[places[k]].pixel *= scale;
    }
  }
  return tracks;
}

std::vector<PatchTrack> PatchTracker::TrackInOctave(
    const ImagePyramid& from, const ImagePyramid& to, const std::vector<Eigen::Vector2d>& pixels,
    const std::vector<Eigen::Vector2d>& predicted) const {
  std::vector<PatchTrack> tracks(pixels.size());
  if (pixels.empty()) return tracks;
  std::vector<cv::Point2f> start, found, back;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    start.push_back(ToPoint(pixels[i]));
    found.push_back(ToPoint(predicted[i]));
  }
  back = start;
  const cv::Size window(config_.window_px, config_.window_px);
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  constexpr double kMinEigenvalue = 1e-5;
  std::vector<std::uint8_t> forth_ok, back_ok;
  cv::calcOpticalFlowPyrLK(from, to, start, found, forth_ok, cv::noArray(), window,
                           config_.levels - 1, until, cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
  const bool back_too = config_.max_forward_backward_px > 0.0;
  if (back_too) {
    // Back from near the truth: the finest scales tell.
    cv::calcOpticalFlowPyrLK(to, from, found, back, back_ok, cv::noArray(), window, 1, until,
                             cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    PatchTrack& track = tracks[i];
    track.pixel = Eigen::Vector2d(found[i].x, found[i].y);
    track.status = TrackStatus::kOutside;
    if (!IsInside(from[0], pixels[i]) || !IsInside(to[0], predicted[i])) continue;
    track.status = TrackStatus::kNotFound;
    if (forth_ok[i] == 0) continue;
    track.status = TrackStatus::kOutside;
    if (!IsInside(to[0], track.pixel)) continue;
    track.status = TrackStatus::kForwardBackward;
    const Eigen::Vector2d returned(back[i].x, back[i].y);
    if (back_too &&
        (back_ok[i] == 0 || (returned - pixels[i]).norm() > config_.max_forward_backward_px)) {
      continue;
    }
    track.status = TrackStatus::kTracked;
    if (config_.patch_radius_px == 0) continue;
    const auto patch = PatchTemplate::Make(from[0], pixels[i], config_.patch_radius_px);
    const auto aligned =
        patch.has_value()
            ? patch->Align(to[0], track.pixel, Eigen::Matrix2d::Identity(), config_.affine)
            : std::nullopt;
    if (!aligned.has_value() || (aligned->pixel - track.pixel).norm() > config_.max_align_px) {
      track.status = TrackStatus::kNotFound;
      continue;
    }
    track.pixel = aligned->pixel;
    track.correlation = aligned->correlation;
    if (track.correlation < config_.min_correlation) track.status = TrackStatus::kUnlike;
  }
  return tracks;
}

}  // namespace drydock::svin2
