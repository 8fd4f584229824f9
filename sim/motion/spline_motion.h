// Motion along a smooth curve through way-points.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/motion/motion.h"
#include "sim/motion/motion_config.h"
#include "sim/motion/quintic_spline.h"
#include "sim/motion/sway.h"

namespace drydock::sim {

/// A four times continuously differentiable curve in position, yaw and pitch through the way-points
/// at nearly constant speed, after a rest at the first of them, with sway on top. Every derivative
/// is analytic, so the IMU that is read from it is exact. R_WI = Rz(yaw) Ry(pitch) Rx(roll).
class SplineMotion final : public Motion {
 public:
  /// InputError if the curve strays far from the polygon of the way-points.
  SplineMotion(const MotionConfig& config, std::uint64_t seed);

  MotionState At(Time t) const override;
  /// The index of the way-point that is nearest in time.
  std::size_t NearestWaypoint(Time t) const;
  Time End() const override { return Time::FromSeconds(rest_s_ + path_.end()); }

 private:
  double rest_s_;
  QuinticSpline path_;  ///< x y z yaw pitch over seconds after the rest.
  Sway sway_;
};

}  // namespace drydock::sim
