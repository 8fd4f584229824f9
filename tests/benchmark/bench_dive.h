// What the benchmarks of the simulator share: the bus dive as users run it.
#pragma once

#include <vector>

#include "scenarios/runner/scenario.h"
#include "sim/motion/spline_motion.h"
#include "sim/world/world.h"

namespace drydock::benchmark {

struct BenchDive {
  Scenario scenario;
  Rig rig;
  sim::SplineMotion motion;
  sim::World world;

  BenchDive();
  /// Poses of the body spread evenly over the dive.
  std::vector<Pose> Poses(int count) const;
};

}  // namespace drydock::benchmark
