// The sonar along the bus dive: single rays, fans of rays, and whole pings.
#include <Eigen/Geometry>

#include <benchmark/benchmark.h>

#include "sensors_models/models/sonar_beam.h"
#include "sensors_models/models/sonar_model.h"
#include "sim/sensors/sonar.h"
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

void SonarFans(::benchmark::State& state) {
  const BenchDive dive;
  const sim::RayScene rays(dive.world);
  const std::vector<Pose> poses = dive.Poses(64);
  const SonarBeamRays beam = MakeSonarBeamRays(dive.rig.sonar.beam_width_rad, 192);
  std::int64_t ping = 0;
  while (state.KeepRunning()) {
    const Pose T_WS = poses[static_cast<std::size_t>(ping) % poses.size()] * dive.rig.sonar.T_IS;
    const Eigen::AngleAxisd head(SonarHeadAngle(dive.rig.sonar, ping), Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d turn = T_WS.R() * head.toRotationMatrix();
    const sim::RayFan fan = (turn * beam.directions).cast<float>();
    ::benchmark::DoNotOptimize(rays.CastFan(T_WS.p(), fan, dive.rig.sonar.max_range_m));
    ++ping;
  }
  state.SetItemsProcessed(ping * beam.directions.cols());
}

/// Pings a second; `time_a_simulated_s` is the time of one core for a second of them.
void SonarPings(::benchmark::State& state) {
  const BenchDive dive;
  const sim::RayScene rays(dive.world);
  sim::SonarEffects effects;
  effects.profiles = state.range(0) != 0;
  sim::Sonar sonar(dive.motion, dive.world, rays, dive.rig.sonar, true, effects, 1);
  while (state.KeepRunning()) ::benchmark::DoNotOptimize(sonar.Observe());
  state.SetItemsProcessed(state.iterations());
  state.counters["time_a_simulated_s"] =
      ::benchmark::Counter(static_cast<double>(state.iterations()) / dive.rig.sonar.rate_hz,
                           ::benchmark::Counter::kIsRate | ::benchmark::Counter::kInvert);
}

BENCHMARK(SonarRays);
BENCHMARK(SonarFans);
BENCHMARK(SonarPings)->ArgName("profiles")->Arg(0)->Arg(1);

}  // namespace
}  // namespace drydock::benchmark
