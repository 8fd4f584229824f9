// The body's pose from landmarks that its cameras see, though some are taken for others.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "estimator/svin2/frontend/stereo_geometry.h"
#include "sensors_models/base/pose.h"

namespace drydock::svin2 {

/// A landmark seen by one of the cameras.
struct LandmarkObservation {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  int camera = 0;                                 ///< 0 left, 1 right.
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double scale = 1.0;  ///< By which its errors are larger than those of fine points.
};

struct RigRansacConfig {
  double max_error_px = 3.0;   ///< Reprojection error of an inlier of scale 1.
  int min_inliers = 10;        ///< With fewer there is no pose.
  int max_iterations = 200;    ///< Of sampling, less where many agree early:
  double confidence = 0.9999;  ///< of having drawn three inliers.
  int refinements = 10;        ///< Gauss-Newton steps at most, after each choice of inliers.
};

struct RigPose {
  Pose T_WI;
  std::vector<std::size_t> inliers;  ///< Indices of observations, rising.
};

/// RANSAC over both cameras at once: three landmarks of one camera give a pose (P3P), all
/// observations of both judge it, and Gauss-Newton with Cauchy's loss refines the best on its
/// inliers. `prior`, where there is one, is judged like a sample. Deterministic: samples are a
/// function of `seed` and the observations' order alone. Nothing if too few agree.
std::optional<RigPose> EstimateRigPose(const StereoGeometry& rig,
                                       const std::vector<LandmarkObservation>& observations,
                                       const std::optional<Pose>& prior, std::uint64_t seed,
                                       const RigRansacConfig& config = {});

}  // namespace drydock::svin2
