// Landmarks from two or more views, with their uncertainty.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sensors_models/base/pose.h"
#include "sensors_models/models/camera_model.h"

namespace drydock::svin2 {

/// What one camera saw of a landmark, from a known place.
struct View {
  const CameraModel* camera = nullptr;  ///< Not owned; outlives the call.
  Pose T_WC;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma_px = 1.0;  ///< Standard deviation of each coordinate.
};

struct TriangulationConfig {
  double min_parallax_rad = 0.004;  ///< Largest angle between two rays; 35 m from the v3 rig.
  double max_chi2 = 9.0;            ///< Of each view's reprojection error, squared and weighted.
  double min_depth_m = 0.1;         ///< In front of each camera, along its axis.
  double max_depth_m = 60.0;
};

enum class TriangulationStatus { kGood, kNoRay, kLowParallax, kOutOfRange, kHighChi2 };

struct Triangulation {
  TriangulationStatus status = TriangulationStatus::kNoRay;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< [m^2], in W, of the views' pixels.
  double parallax_rad = 0.0;                             ///< Largest angle between two rays.
  double max_chi2 = 0.0;                                 ///< Of the worst view.

  bool IsGood() const { return status == TriangulationStatus::kGood; }
};

/// The point that explains all `views` best: nearest to their rays at first, then least squares of
/// the pixels' errors by Gauss-Newton. Poses count as exact. Every number that was reached is
/// given, whatever the status; p_W and the covariance hold from kOutOfRange's gate on.
Triangulation Triangulate(const std::vector<View>& views, const TriangulationConfig& config = {});

}  // namespace drydock::svin2
