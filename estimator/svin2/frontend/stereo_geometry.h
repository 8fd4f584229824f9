// What the calibrated rig says about where one camera sees what the other has seen.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "sensors_models/base/pose.h"
#include "sensors_models/measurement/rig.h"
#include "sensors_models/models/camera_model.h"

namespace drydock::svin2 {

/// How far `pixel_b` lies from the epipolar line of `pixel_a` [px of b, but
/// without what a radtan lens distorts]. T_BA maps points of camera a into camera b. Nothing where
/// a pixel has no ray or there is no line (the ray of a goes through b).
std::optional<double> EpipolarDistance(const CameraModel& a, const Eigen::Vector2d& pixel_a,
                                       const CameraModel& b, const Eigen::Vector2d& pixel_b,
                                       const Pose& T_BA);

/// Both cameras of a rig.
class StereoGeometry {
 public:
  explicit StereoGeometry(const StereoSheet& sheet);

  const CameraModel& camera(int index) const { return cameras_[index]; }
  const Pose& T_IC(int index) const { return T_IC_[index]; }

  /// As the free function, from the left camera (0) to the right (1).
  std::optional<double> EpipolarDistance(const Eigen::Vector2d& left,
                                         const Eigen::Vector2d& right) const;

  /// The right camera's pixel of what the left sees at `left`, 1 / `inverse_depth` in front of it
  /// along its axis [1/m]; 0 is infinitely far. Nothing if there is none; it may lie outside the
  /// image.
  std::optional<Eigen::Vector2d> Transfer(const Eigen::Vector2d& left, double inverse_depth) const;

  /// The inverse depth [1/m] that explains `right` best, negative where the rays meet behind the
  /// left camera. Nothing where a pixel has no ray.
  std::optional<double> InverseDepth(const Eigen::Vector2d& left,
                                     const Eigen::Vector2d& right) const;

 private:
  std::array<CameraModel, 2> cameras_;
  std::array<Pose, 2> T_IC_;
  Pose T_C1C0_;
};

}  // namespace drydock::svin2
