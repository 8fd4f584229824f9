// A simulated dive, kept in memory for many estimators.
#pragma once

#include <string>
#include <vector>

#include "scenarios/runner/dive.h"
#include "scenarios/runner/scenario.h"
#include "sensors_models/base/resources.h"

namespace drydock::testing {

struct RecordedDive {
  Rig rig;
  NavState start;
  Trajectory truth;
  std::vector<Measurement> measurements;  ///< In order of arrival.
};

/// scenarios/bus.yaml with what `overrides` change. A second takes 14 MB.
inline RecordedDive RecordBus(const std::vector<std::string>& overrides) {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml", overrides);
  Dive dive(scenario, sim::RendererBackend::kAuto);
  RecordedDive recorded{dive.rig(), dive.InitialState(), dive.Truth(), {}};
  while (auto observation = dive.Next()) recorded.measurements.push_back(observation->measurement);
  return recorded;
}

}  // namespace drydock::testing
