#include "tests/integration/start_trial.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "estimator/registry/registry.h"
#include "scenarios/results/start_watch.h"
#include "scenarios/scoring/initialisation.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::testing {
namespace {

constexpr double kFirstMotion = 0.05;  // [m], as the scorecard has it.
/// Five seconds, and a frame more.
constexpr Duration kFollowed{5'200'000'000};

/// When a trial that started at `start` is over.
std::optional<Time> EndOfTrial(const Trajectory& truth, Time start) {
  const auto first = std::find_if(truth.begin(), truth.end(),
                                  [start](const StampedPose& pose) { return pose.t >= start; });
  const auto moved = std::find_if(first, truth.end(), [&](const StampedPose& pose) {
    return (pose.T_WI.p() - first->T_WI.p()).norm() >= kFirstMotion;
  });
  if (moved == truth.end()) return std::nullopt;
  return moved->t + kFollowed;
}

}  // namespace

StartTrial StartAt(const RecordedDive& dive, Time begin) {
  const auto estimator = FindEstimator("svin2-noloop").make(dive.rig, NoOptions());
  estimator->Start(std::nullopt);
  StartTrial trial;
  trial.begun_s = begin.Seconds();
  StartWatch watch;
  std::optional<Time> end;
  for (const Measurement& measurement : dive.measurements) {
    if (measurement.t < begin) continue;
    if (end && measurement.t > *end) break;
    estimator->Add(measurement);
    watch.Look(measurement.t_arrival, estimator->Latest());
    for (const EstimatorEvent& event : estimator->TakeEvents()) trial.report += event.message;
    if (trial.wait_s || !estimator->Latest()) continue;
    const Time started = estimator->Latest()->state.t;
    trial.wait_s = (started - begin).Seconds();
    end = EndOfTrial(dive.truth, started);
  }
  trial.scale_error_percent = score::InitialScaleErrorPercent(dive.truth, estimator->Odometry());
  trial.false_starts = watch.FalseStarts().value_or(0);
  return trial;
}

std::vector<StartTrial> StartAtRandom(const RecordedDive& dive, const std::string& stream,
                                      int count, double from_s, double to_s) {
  const RandomStream random(1, stream);
  std::vector<StartTrial> trials;
  for (int k = 0; k < count; ++k) {
    const double share = random.UniformAt(static_cast<std::uint64_t>(k));
    trials.push_back(StartAt(dive, Time::FromSeconds(from_s + share * (to_s - from_s))));
  }
  return trials;
}

std::string Line(const StartTrial& trial) {
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", *value) : std::string("none");
  };
  return fmt::format("begun at {:.2f} s: wait {} s, scale error {} %, {} false; {}", trial.begun_s,
                     number(trial.wait_s), number(trial.scale_error_percent), trial.false_starts,
                     trial.report);
}

}  // namespace drydock::testing
