// How well a keypoint's place in the image is known.
#pragma once

#include <algorithm>
#include <cmath>

#include "estimator/svin2/frontend/image_pyramid.h"

namespace drydock::svin2 {

/// Standard deviations of each coordinate [px]. As measured, see docs/models.md.
struct KeypointSigma {
  double recognised_px = 0.05;  ///< Where the patch is recognised perfectly.
  /// Of sqrt(1 - correlation), which goes as noise over contrast does. Both add in squares.
  double per_unlikeness_px = 1.0;
  double coarse_px = 0.38;  ///< At least this for coarse points, in pixels of their octave.

  /// In pixels of the image.
  double Of(int octave, double correlation) const {
    const double unlikeness = std::sqrt(std::max(1.0 - correlation, 0.0));
    const double sigma = std::hypot(recognised_px, per_unlikeness_px * unlikeness);
    return octave == 0 ? sigma : OctaveScale(octave) * std::max(sigma, coarse_px);
  }
};

}  // namespace drydock::svin2
