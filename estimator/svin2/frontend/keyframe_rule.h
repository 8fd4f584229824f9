// When the scene has changed enough to keep a frame.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "estimator/svin2/frontend/tracked_frame.h"

namespace drydock::svin2 {

/// The rule of OKVIS (Leutenegger et al. 2015), for tracks instead of matches: a frame is a
/// keyframe if, in both cameras, what it still shares with the last keyframe covers too little of
/// the area that was covered then, or too few of the points. Also if few points are left at all.
/// What is gone in the frame after a keyframe does not count: in haze much of it was noise.
class KeyframeRule {
 public:
  struct Config {
    double max_overlap = 0.6;      ///< Of the areas of the points' convex hulls.
    double max_match_ratio = 0.2;  ///< Of the numbers of points.
    /// Least points, as a share of the last keyframe's; what is lost must be replaced some day.
    double min_tracked_share = 0.5;
    int min_points = 10;  ///< With fewer tracked, a keyframe is due; a frame with fewer is none.
    int min_gap = 3;      ///< Frames from one keyframe to the next, unless no point is left.
    int max_gap = 100;    ///< A frame this long after the last keyframe is one in any case.
  };

  /// Throws InputError for values that cannot be used.
  explicit KeyframeRule(const Config& config);

  /// Whether a frame of these points, all of them tracked, should be a keyframe; counts the frame.
  bool Decide(const std::vector<TrackedPoint>& points);
  /// What the keyframe shows, new corners included. False if it is too little to be one: of
  /// darkness no keyframe is made.
  bool Keep(const std::vector<TrackedPoint>& points);

 private:
  struct Seen {
    std::set<LandmarkId> ids;
    double area = 0.0;  // Of the convex hull [px^2].
  };
  static Seen See(const std::vector<TrackedPoint>& points, int camera,
                  const std::set<LandmarkId>* known);

  bool IsTooLittle(const std::vector<TrackedPoint>& points) const;
  void Refer(const std::vector<TrackedPoint>& points);

  Config config_;
  bool has_keyframe_ = false;
  int frames_since_ = 0;
  std::array<Seen, 2> keyframe_;
};

}  // namespace drydock::svin2
