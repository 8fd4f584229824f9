// What the front end knows of one stereo frame: which landmarks both cameras see, and where.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "sensors_models/base/time.h"

namespace drydock::svin2 {

/// Never used again for another landmark.
using LandmarkId = std::uint64_t;

struct TrackedPoint {
  LandmarkId id = 0;
  Eigen::Vector2d left = Eigen::Vector2d::Zero();  ///< Pixel in the left image, distorted.
  std::optional<Eigen::Vector2d> right;            ///< In the right one, where it was found there.
  double sigma_px = 1.0;                           ///< Of each coordinate.
};

struct TrackedFrame {
  Time t;
  std::vector<TrackedPoint> points;  ///< Sorted by id.
  bool is_keyframe = false;
  int tracked = 0;          ///< Points that the frame before had as well.
  int empty_quadrants = 0;  ///< Quarters of the left image without a point.
};

}  // namespace drydock::svin2
