// What the pose graph costs: one optimisation from odometry's poses, and taking loops in.
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/estimator/svin2/pose_graph/synthetic_graph.h"

namespace drydock::svin2 {
namespace {

using testing::SyntheticDive;

/// `keyframes` in laps of 100.
SyntheticDive Dive(std::int64_t keyframes) {
  testing::SyntheticDiveConfig config;
  config.laps = keyframes / config.per_lap;
  return SyntheticDive(config);
}

PoseGraph Graph(std::int64_t keyframes, std::int64_t loops) {
  SyntheticDive dive = Dive(keyframes);
  PoseGraph graph;
  dive.AddTo(graph);
  const std::int64_t stride = (keyframes - 100) / loops;
  for (const PoseGraphEdge& loop : dive.TrueLoops(keyframes - loops * stride, keyframes, stride))
    graph.AddEdge(loop);
  return graph;
}

/// Counter: iterations.
void Optimise(::benchmark::State& state) {
  const PoseGraph graph = Graph(state.range(0), state.range(1));
  PoseGraphReport report;
  while (state.KeepRunning()) report = graph.Optimise({}).report;
  state.counters["iterations"] = report.iterations;
}
BENCHMARK(Optimise)->Args({500, 50})->Args({5000, 500})->Unit(::benchmark::kMillisecond);

/// The same once more: what another loop costs a graph that is optimised already.
void OptimiseAgain(::benchmark::State& state) {
  PoseGraph graph = Graph(state.range(0), state.range(1));
  graph.Apply(graph.Optimise({}));
  while (state.KeepRunning()) ::benchmark::DoNotOptimize(graph.Optimise({}));
}
BENCHMARK(OptimiseAgain)->Args({500, 50})->Args({5000, 500})->Unit(::benchmark::kMillisecond);

/// Taking in all nodes and edges, each loop held against all others.
void Build(::benchmark::State& state) {
  while (state.KeepRunning()) ::benchmark::DoNotOptimize(Graph(state.range(0), state.range(1)));
}
BENCHMARK(Build)->Args({500, 50})->Args({5000, 500})->Unit(::benchmark::kMillisecond);

/// What lock step costs beside: a copy of the graph.
void Copy(::benchmark::State& state) {
  const PoseGraph graph = Graph(state.range(0), state.range(1));
  while (state.KeepRunning()) {
    const PoseGraph copy = graph;
    ::benchmark::DoNotOptimize(&copy);
  }
}
BENCHMARK(Copy)->Args({5000, 500})->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace drydock::svin2
