// What SVIn2 costs a stereo frame, and which stage takes what share.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "estimator/registry/registry.h"
#include "scenarios/runner/dive.h"
#include "sensors_models/base/resources.h"

namespace drydock::benchmark {
namespace {

struct RecordedDive {
  Rig rig;
  std::vector<Measurement> measurements;
};

/// The first seconds of the bus dive, at visibility `visibility_m`.
RecordedDive Record(std::int64_t visibility_m) {
  const Scenario scenario =
      LoadScenario(DataDirectory() / "scenarios" / "bus.yaml",
                   {"duration_s=12", fmt::format("water.visibility_m={}", visibility_m)});
  Dive dive(scenario, sim::RendererBackend::kAuto);
  RecordedDive recorded{dive.rig(), {}};
  while (auto observation = dive.Next()) recorded.measurements.push_back(observation->measurement);
  return recorded;
}

double Quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Counters: milliseconds a frame (median and 99 %), and each stage's share in percent.
void Svin2Frame(::benchmark::State& state) {
  const RecordedDive dive = Record(state.range(0));
  std::vector<double> frames_ms;
  EstimatorTimings stages;
  while (state.KeepRunning()) {
    const auto estimator = FindEstimator("svin2-noloop").make(dive.rig, NoOptions());
    estimator->Start(std::nullopt);
    for (const Measurement& measurement : dive.measurements) {
      const std::size_t poses = estimator->Odometry().size();
      const auto start = std::chrono::steady_clock::now();
      estimator->Add(measurement);
      const std::chrono::duration<double, std::milli> cost =
          std::chrono::steady_clock::now() - start;
      if (estimator->Odometry().size() > poses) frames_ms.push_back(cost.count());
    }
    stages = estimator->Timings();
  }
  state.counters["median_ms"] = Quantile(frames_ms, 0.5);
  state.counters["p99_ms"] = Quantile(frames_ms, 0.99);
  double total = 0.0;
  for (const StageTimings& stage : stages) total += stage.total_s;
  for (const StageTimings& stage : stages)
    state.counters[stage.name + "_%"] = 100.0 * stage.total_s / total;
}
BENCHMARK(Svin2Frame)->Arg(12)->Arg(6)->Iterations(1)->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace drydock::benchmark
