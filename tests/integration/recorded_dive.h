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

/// A scenario of the house, by its file's name, with what `overrides` change. A second takes 14 MB.
inline RecordedDive Record(const std::string& file, const std::vector<std::string>& overrides) {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / file, overrides);
  Dive dive(scenario, sim::RendererBackend::kAuto);
  RecordedDive recorded{dive.rig(), dive.InitialState(), dive.Truth(), {}};
  while (auto observation = dive.Next()) recorded.measurements.push_back(observation->measurement);
  return recorded;
}

inline RecordedDive RecordBus(const std::vector<std::string>& overrides) {
  return Record("bus.yaml", overrides);
}

/// A stereo frame's images turned black; other measurements stay.
inline Measurement Blackened(const Measurement& measurement) {
  Measurement black = measurement;
  if (auto* frame = std::get_if<StereoFrame>(&black.reading))
    for (cv::Mat& image : frame->images) image = cv::Mat(image.size(), image.type(), cv::Scalar(0));
  return black;
}

}  // namespace drydock::testing
