// What the visual front end has to say about one stereo frame.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// Counts up from 1 and is never used again.
using LandmarkId = std::uint64_t;

struct TrackedPoint {
  LandmarkId id = 0;
  Eigen::Vector2d left = Eigen::Vector2d::Zero();  ///< Pixel of the distorted image.
  std::optional<Eigen::Vector2d> right;            ///< Where stereo found it in this frame.
  double sigma_px = 1.0;                           ///< Standard deviation of each coordinate.
  /// Where the frame is described and the pattern fits the image.
  std::optional<Descriptor> descriptor = std::nullopt;
};

struct TrackedFrame {
  Time t;
  std::vector<TrackedPoint> points;  ///< Sorted by id.
  bool is_keyframe = false;
  bool is_described = false;  ///< Its points have descriptors.
  /// Of a described frame with few points: coarse corners that both eyes see and nobody follows.
  /// They serve to know the place again. Their ids lie above
  /// those of all landmarks.
  std::vector<TrackedPoint> unfollowed;
  // For health:
  int tracked = 0;          ///< Points that were known before this frame.
  int empty_quadrants = 4;  ///< Of the left image's four.
};

}  // namespace drydock::svin2
