// How well a keypoint's place in the image is known.
#pragma once

#include <algorithm>

#include "estimator/svin2/frontend/image_pyramid.h"

namespace drydock::svin2 {

/// Standard deviations of each coordinate [px]. As measured, see docs/models.md.
struct KeypointSigma {
  double recognised_px = 0.12;     ///< Where the patch is recognised perfectly,
  double per_unlikeness_px = 0.9;  ///< and how it grows with 1 - correlation.
  /// At least this times 4^octave for coarse points: their patches are large, and not flat.
  double coarse_px = 0.14;

  /// In pixels of the image.
  double Of(int octave, double correlation) const {
    const double scale = OctaveScale(octave);
    const double sigma = recognised_px + per_unlikeness_px * std::max(1.0 - correlation, 0.0);
    return octave == 0 ? sigma : std::max(scale * sigma, scale * scale * coarse_px);
  }
};

}  // namespace drydock::svin2
