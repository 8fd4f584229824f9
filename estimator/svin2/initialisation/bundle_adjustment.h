// Poses and landmarks that explain a few frames' pixels best, and how well they are known.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

struct BundleObservation {
  int landmark = 0;  ///< Index.
  int frame = 0;     ///< Index.
  int camera = 0;    ///< 0 left, 1 right.
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma_px = 1.0;
};

/// V is any fixed frame.
struct Bundle {
  std::vector<Pose> T_VI;                       ///< One a frame.
  std::vector<Eigen::Vector3d> landmarks;       ///< [m, in V]
  std::vector<BundleObservation> observations;  ///< Sorted by landmark.
};

struct AdjustedBundle {
  std::vector<Pose> T_VI;
  std::vector<Eigen::Vector3d> landmarks;
  /// Of the tangents [dp, da] of all poses but the first, landmarks marginalised; 6 (frames - 1)
  /// square. Pixels that scatter more than their sigma says lower it as a whole.
  Eigen::MatrixXd information;
  double mean_chi2 = 0.0;  ///< Of an observation, weighted; at most 2 where noise is as expected.
};

/// Gauss-Newton with Cauchy's loss, landmarks eliminated by Schur's complement. The first pose
/// stays where it is. (By hand rather than by Ceres because the poses' information is half of the
/// answer.) Nothing where the pixels leave a pose undetermined.
std::optional<AdjustedBundle> AdjustBundle(const StereoGeometry& rig, const Bundle& bundle,
                                           int max_iterations);

}  // namespace drydock::svin2
