// A scenario brought to life.
#pragma once

#include <optional>

#include "estimator/interface/estimator.h"
#include "scenarios/runner/scenario.h"
#include "sim/motion/spline_motion.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/world/ray_scene.h"
#include "sim/world/world.h"

namespace drydock {

/// World, motion and sensors of one scenario and seed: an endless supply of measurements up to
/// End(), with the truth.
class Dive {
 public:
  /// Prepares the scene (cached) and everything else. InputError for whatever the scenario cannot
  /// mean: an unknown scene, a path that touches it, no OpenGL.
  Dive(const Scenario& scenario, sim::RendererBackend backend);

  /// The next observation to arrive; nothing at the end of the dive.
  std::optional<sim::Observation> Next() { return suite_.Next(); }

  Time End() const { return end_; }
  const sim::Motion& motion() const { return motion_; }
  const sim::RayScene& rays() const { return rays_; }
  const Rig& rig() const { return rig_; }
  /// "egl", "osmesa", or "none" without a camera.
  std::string RendererName() const;
  /// OpenGL's name of the device that draws.
  std::string DeviceName() const;

  /// The true state at the start.
  NavState InitialState() const;
  /// The truth at every instant at which the IMU or the camera measures.
  Trajectory Truth() const;

 private:
  Rig rig_;
  sim::SplineMotion motion_;
  Time end_;
  sim::World world_;
  sim::RayScene rays_;
  sim::SensorSuite suite_;
};

}  // namespace drydock
