// Whether two keyframes show the same place, and how the body moved in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/rig_ransac.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/loop/loop_matcher.h"

namespace drydock::svin2 {

/// Why a loop is not believed.
enum class LoopStatus {
  kGood,
  kFewMatches,   ///< Fewer matches than inliers are asked for.
  kFewInliers,   ///< That agree on a motion.
  kLowShare,     ///< Too many matches disagree.
  kNarrow,       ///< What agrees lies in one spot, or in a line, of one of the images.
  kFar,          ///< The motion is longer, or turns further, than points are recognised over.
  kTilted,       ///< Gravity would have turned.
  kOffHeight,    ///< The pressure sensor says otherwise.
  kPoorFit,      ///< Pixels scatter more than they should (Relocaliser).
  kUndetermined  ///< The motion is not known well enough (Relocaliser).
};

/// "few inliers", for events and tables.
const char* ToString(LoopStatus status);

struct VerifiedLoop {
  LoopStatus status = LoopStatus::kFewMatches;
  Pose T_then_now;                 ///< Holds from kLowShare on.
  std::vector<LoopMatch> inliers;  ///< As far as they were counted.

  bool IsGood() const { return status == LoopStatus::kGood; }
};

/// Verifies by geometry: P3P and RANSAC over both cameras with the landmarks of one keyframe and
/// the pixels of the other, then every match by its reprojection errors both ways. Deterministic.
class LoopVerifier {
 public:
  struct Config {
    int min_inliers = 15;           ///< Matches.
    double min_inlier_share = 0.3;  ///< Of the matches.
    /// Reprojection error of an inlier. Corners are found up to some 2 px beside; and what stereo
    /// knows to 0.2 px of disparity is, from ten baselines beside, off by 2 px. Times ErrorScale.
    double max_error_px = 5.0;
    int max_iterations = 100;
    /// RMS of the inliers' pixels about their mean, in the direction in which it is smallest.
    double min_spread_px = 40.0;
    double max_distance_m = 5.0;
    double max_angle_rad = 0.8;
    /// Between gravity as odometry has it in `now`, and as `then` has it by the loop: roll and
    /// pitch do not drift.
    double max_tilt_error_rad = 0.05;
    /// Height by odometry and by the loop, in the same map, where pressure keeps odometry's from
    /// drifting [m].
    std::optional<double> max_height_error_m = std::nullopt;
  };

  /// Throws InputError for values that cannot be used.
  LoopVerifier(const Config& config, const StereoGeometry& rig);

  /// `T_then_now`, a guess where there is one, is judged like a sample of RANSAC.
  VerifiedLoop Verify(const Keyframe& now, const Keyframe& then,
                      const std::vector<LoopMatch>& matches,
                      const std::optional<Pose>& T_then_now = std::nullopt) const;

 private:
  struct Candidates;
  std::optional<Pose> FindPose(const Candidates& candidates, const std::optional<Pose>& guess,
                               std::uint64_t seed) const;
  LoopStatus Judge(const Keyframe& now, const Keyframe& then, std::size_t matches,
                   const VerifiedLoop& loop) const;

  Config config_;
  StereoGeometry rig_;
};

}  // namespace drydock::svin2
