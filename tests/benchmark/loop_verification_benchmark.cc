// What one candidate of a loop costs: matching, verification and relocalisation.
#include <string>

#include <benchmark/benchmark.h>

#include "estimator/svin2/loop/loop_checker.h"
#include "tests/estimator/svin2/loop/synthetic_loop.h"

namespace drydock::svin2 {
namespace {

/// Keyframes of 250 points, as the front end has them, of which `shared` are the same.
testing::SyntheticLoop Revisit(int shared) {
  testing::SyntheticLoop loop =
      testing::MakeLoop({.landmarks = 250, .noisy = true, .offset_px = 0.6, .window_sigma = 0.5});
  const testing::SyntheticLoop other = testing::MakeLoop({.seed = 2, .landmarks = 250});
  for (auto k = static_cast<std::size_t>(shared); k < 250; ++k)
    loop.then.points[k] = other.then.points[k];
  return loop;
}

void CheckLoop(::benchmark::State& state) {
  const testing::SyntheticLoop loop = Revisit(static_cast<int>(state.range(0)));
  const LoopChecker checker({}, loop.rig);
  Relocalisation found;
  while (state.KeepRunning()) found = checker.Check(loop.now, loop.then);
  state.counters["inliers"] = static_cast<double>(found.inliers.size());
  state.SetLabel(ToString(found.status));
}
BENCHMARK(CheckLoop)->Arg(0)->Arg(12)->Arg(40)->Arg(100)->Arg(250)->Unit(::benchmark::kMillisecond);

/// The worst case of RANSAC: matches, and no motion in them.
void CheckLookAlike(::benchmark::State& state) {
  testing::SyntheticLoop loop = Revisit(60);
  const Descriptor first = loop.now.points.front().descriptor;
  for (std::size_t k = 0; k + 1 < loop.now.points.size(); ++k)
    loop.now.points[k].descriptor = loop.now.points[k + 1].descriptor;
  loop.now.points.back().descriptor = first;
  const LoopChecker checker({}, loop.rig);
  Relocalisation found;
  while (state.KeepRunning()) found = checker.Check(loop.now, loop.then, loop.T_then_now);
  state.SetLabel(ToString(found.status));
}
BENCHMARK(CheckLookAlike)->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace drydock::svin2
