// Follows points without letting their errors add up.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimator/svin2/frontend/feature_track.h"
#include "estimator/svin2/frontend/image_pyramid.h"
#include "estimator/svin2/frontend/patch_template.h"

namespace drydock::svin2 {

/// Looks for the patch that a point had when it was first seen. Where that can no longer be
/// recognised, or has changed its size too much, the patch of the last frame takes its place.
/// A track is looked for at its octave's level of the pyramids.
class AnchorTracker {
 public:
  /// In pixels of the track's octave.
  struct Config {
    int patch_radius_px = 12;      ///< Patches are 2 r + 1 squared.
    bool affine = true;            ///< The patch may turn, stretch and shear, else only shift.
    double min_correlation = 0.7;  ///< Of the patches' grey values, once aligned.
    double max_align_px = 2.0;     ///< An alignment that moves further has gone astray.
    double max_scale = 1.6;        ///< Of lengths, since the anchor was taken; or its inverse.
    int max_renewals = 20;         ///< A point whose anchor changed more often is given up.
  };

  /// Throws InputError for values that cannot be used.
  explicit AnchorTracker(const Config& config);

  /// Takes the patch of `track` as it is in `image` for its anchor; false if there is none.
  bool Anchor(const ImagePyramid& image, FeatureTrack& track) const;

  /// Finds the track of the image `before` in the image `now` near `start`, and updates it; false
  /// if it is not there.
  bool Follow(const ImagePyramid& before, const ImagePyramid& now, const Eigen::Vector2d& start,
              FeatureTrack& track) const;

  /// Where the right image of the frame at hand shows the track, near `start`. Looked for is the
  /// anchor again: both pixels then mean the same point of the scene.
  std::optional<Eigen::Vector2d> FindInRight(const ImagePyramid& right,
                                             const Eigen::Vector2d& start,
                                             const FeatureTrack& track) const;

  /// Finds the anchor of a track that was not seen for a while.
  bool Regain(const ImagePyramid& now, const Eigen::Vector2d& start, FeatureTrack& track) const;

 private:
  std::optional<PatchAlignment> Align(const ImagePyramid& image, const Eigen::Vector2d& start,
                                      double max_align_px, const FeatureTrack& track) const;
  bool Update(const ImagePyramid& now, const Eigen::Vector2d& start, double max_align_px,
              FeatureTrack& track) const;

  Config config_;
};

}  // namespace drydock::svin2
