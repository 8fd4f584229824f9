// The motion between two keyframes of one place, as exactly as their measurements have it (paper
// eq. 16).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "estimator/svin2/graph/factor_graph.h"
#include "estimator/svin2/loop/keyframe.h"
#include "estimator/svin2/loop/loop_matcher.h"
#include "estimator/svin2/loop/loop_verifier.h"

namespace drydock::svin2 {

struct Relocalisation {
  LoopStatus status = LoopStatus::kFewInliers;
  Pose T_then_now;
  /// Of the tangent [dp, da] of T_then_now (p + dp, exp(da) q) [m, rad], in then's body frame: the
  /// error of T_then_now.BoxMinus(truth). See loop_edge.h for other conventions.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  std::vector<LoopMatch> inliers;
  double chi2_per_dof = 0.0;  ///< 1 where pixels scatter as expected.
  int ranges = 0;             ///< Of the sonar.

  bool IsGood() const { return status == LoopStatus::kGood; }
};

/// Optimises T_then_now and the landmarks of a loop over what both keyframes measured of them:
/// pixels in all four images and sonar ranges, `then` held fixed. First with Cauchy's loss; then
/// landmarks that do not fit are dropped, and the others' plain squares give motion and covariance.
/// Deterministic.
class Relocaliser {
 public:
  struct Config {
    int min_inliers = 15;
    /// How far the corner found in `now` lies beside the one known from `then` (see
    /// RecognisedPointFactor), in standard deviations of now's pixel.
    double offset_per_sigma = 6.0;
    /// The window's landmarks come from many frames: they count as if then's eyes had seen them at
    /// this share of their standard deviation. 0: then's pixels count instead.
    double window_sigma_share = 0.5;
    bool use_sonar = true;
    double cauchy_scale = 1.0;
    double max_landmark_chi2 = 20.0;  ///< Of all that was measured of one landmark.
    double max_chi2_per_dof = 2.5;    ///< Beyond 1 it makes the covariance larger as a whole.
    /// What the errors of neighbouring points have in common is not in the model: by so much the
    /// covariance is larger than it says. Measured, see docs/models.md.
    double covariance_inflation = 2.0;
    double max_sigma_m = 0.1;  ///< Of the motion, in its least known direction.
    double max_sigma_rad = 0.03;
    SolverLimits solver = {.iterations = 10, .seconds = std::nullopt};
  };

  /// Throws InputError for values that cannot be used.
  Relocaliser(const Config& config, const StereoGeometry& rig);

  /// `matches` agree with `T_then_now`, as LoopVerifier found them.
  Relocalisation Relocalise(const Keyframe& now, const Keyframe& then,
                            const std::vector<LoopMatch>& matches, const Pose& T_then_now) const;

 private:
  /// Judges what was found.
  Relocalisation Conclude(Relocalisation result,
                          const std::optional<Eigen::MatrixXd>& covariance) const;

  Config config_;
  StereoGeometry rig_;
};

}  // namespace drydock::svin2
