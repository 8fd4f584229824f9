// Records a dive in EuRoC's layout (euroc_layout.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <opencv2/core/mat.hpp>

#include "scenarios/dataset/truth_state.h"
#include "sensors_models/base/files.h"
#include "sensors_models/measurement/measurement.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::dataset {

/// Writes a recording that appears complete on Commit() or not at all. Numbers are written so that
/// reading gives the same doubles. A file that cannot be written is an InputError.
///
/// Tables are sorted by time whatever the order of the calls; arrivals.csv keeps the order of
/// Add().
class EurocWriter {
 public:
  /// `target` will hold `mav0/`; its parent is made if missing.
  EurocWriter(Rig rig, const std::filesystem::path& target);

  /// Measurements in the order in which the robot has them; stamps are not negative. InputError for
  /// a second one of the same sensor and time, of which EuRoC's tables can hold but one; nothing of
  /// it is kept. Images are written at once: 8-bit grey or BGR, as they are. What follows refuses
  /// repeated times likewise.
  void Add(const Measurement& measurement);
  void AddTruth(Time t, const TruthState& state);
  /// The true range of the ping at `t` [m] (0 where it meets nothing) and what it hit.
  void AddSonarTruth(Time t, double range, std::string_view hit);
  /// What camera 0 (left) or 1 (right) would measure at `t`: CV_32FC1, along its z axis [m].
  void AddDepthImage(std::size_t camera, Time t, const cv::Mat& depth);

  /// Once, at the end.
  void Commit(AtomicDirectory::IfExists if_exists = AtomicDirectory::IfExists::kReplace);

 private:
  using Table = std::map<Time, std::string>;

  void AddRow(const std::string& folder, Time t, std::string row);
  void RequireFree(const std::string& folder, Time t) const;
  void AddReading(Time t, const ImuSample& sample);
  void AddReading(Time t, const StereoFrame& frame);
  void AddReading(Time t, const SonarPing& ping);
  void AddReading(Time t, const DepthSample& sample);
  void WriteTable(const std::string& folder, std::string_view header, std::string_view sheet);
  std::filesystem::path root() const;

  Rig rig_;
  AtomicDirectory directory_;
  std::map<std::string, Table> tables_;  ///< By the sensor's folder.
  std::string arrivals_;
};

}  // namespace drydock::dataset
