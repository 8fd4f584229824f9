#include "tests/benchmark/bench_dive.h"

#include "scenes/scene.h"
#include "sensors_models/base/resources.h"

namespace drydock::benchmark {

BenchDive::BenchDive()
    : scenario(LoadScenario(DataDirectory() / "scenarios" / "bus.yaml")),
      rig(LoadRig(FindRig(scenario.rig))),
      motion(scenario.motion, scenario.seed),
      world(scenes::PrepareScene(scenario.scene.name, scenario.scene.seed, CacheDirectory())) {}

std::vector<Pose> BenchDive::Poses(int count) const {
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    poses.push_back(motion.At({motion.End().ns / count * i}).T_WI);
  }
  return poses;
}

}  // namespace drydock::benchmark
