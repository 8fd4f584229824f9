// Rays of the sonar along the bus dive.
#include <benchmark/benchmark.h>

#include "sensors_models/models/sonar_model.h"
#include "sim/world/ray_scene.h"
#include "tests/benchmark/bench_dive.h"

namespace drydock::benchmark {
namespace {

void SonarRays(::benchmark::State& state) {
  const BenchDive dive;
  const sim::RayScene rays(dive.world);
  const std::vector<Pose> poses = dive.Poses(64);
  std::int64_t ping = 0;
  while (state.KeepRunning()) {
    const Pose T_WS = poses[static_cast<std::size_t>(ping) % poses.size()] * dive.rig.sonar.T_IS;
    const Eigen::Vector3d beam = T_WS.q() * SonarBeam(SonarHeadAngle(dive.rig.sonar, ping));
    ::benchmark::DoNotOptimize(rays.Cast(T_WS.p(), beam, dive.rig.sonar.max_range_m));
    ++ping;
  }
  state.SetItemsProcessed(ping);
}

BENCHMARK(SonarRays);

}  // namespace
}  // namespace drydock::benchmark
