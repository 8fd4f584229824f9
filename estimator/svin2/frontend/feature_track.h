// What the front end remembers of a point that it follows.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/descriptor.h"
#include "estimator/svin2/frontend/patch_template.h"
#include "estimator/svin2/frontend/tracked_frame.h"

namespace drydock::svin2 {

struct FeatureTrack {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();      ///< In the latest frame.
  Eigen::Vector2d left_before = left;                  ///< In the frame before that.
  std::optional<Eigen::Vector2d> right;                ///< In the latest frame.
  Eigen::Matrix2d warp = Eigen::Matrix2d::Identity();  ///< Of the anchor to the latest frame.

  LandmarkId id = 0;
  int octave = 0;  ///< Level of the pyramid that its anchor is of; pixels are the image's.
  /// Of the anchor with the latest frame; of new points, a usual one.
  double correlation = 0.9;
  std::optional<double> inverse_depth;  ///< By stereo [1/m], carried along by motion.
  /// The patch that is looked for in every frame: that of the first frame, as long as it can be
  /// recognised, so that errors do not add up from frame to frame.
  std::shared_ptr<const PatchTemplate> anchor;
  std::optional<Descriptor> descriptor;  ///< In the latest keyframe.
  int age = 0;                           ///< Frames since it was first seen.
  int renewals = 0;                      ///< How often the anchor was replaced.
};

/// How many of `tracks` the right image shows too.
inline int SeenByBoth(const std::vector<FeatureTrack>& tracks) {
  return static_cast<int>(std::ranges::count_if(
      tracks, [](const FeatureTrack& track) { return track.right.has_value(); }));
}

}  // namespace drydock::svin2
