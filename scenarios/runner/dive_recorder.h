// Writes a dive to a dataset as it happens.
#pragma once

#include <filesystem>

#include "scenarios/dataset/euroc_writer.h"
#include "scenarios/runner/dive.h"

namespace drydock {

/// Records every observation of a dive, with its truth, in EuRoC's layout.
class DiveRecorder {
 public:
  /// `dive` must outlive the recorder.
  DiveRecorder(const Dive& dive, const std::filesystem::path& target);

  void Add(const sim::Observation& observation);
  /// Makes the recording appear.
  void Commit() { writer_.Commit(); }

 private:
  void AddTruth(Time t, const sim::ImuTruth& truth);
  void AddTruth(Time t, const sim::SonarTruth& truth);
  void AddTruth(Time t, const sim::StereoTruth& truth);
  void AddTruth(Time, const std::monostate&) {}

  const Dive& dive_;
  dataset::EurocWriter writer_;
};

}  // namespace drydock
