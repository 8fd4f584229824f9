// Reads recordings in EuRoC's layout (euroc_layout.h), ours and others'.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/dataset/euroc_rig.h"
#include "scenarios/dataset/truth_state.h"
#include "sensors_models/base/trajectory.h"
#include "sensors_models/measurement/measurement.h"
#include "sensors_models/measurement/rig.h"

namespace drydock::dataset {

/// A recording, opened: tables are read and checked, images are loaded when their turn comes.
///
/// Measurements come in the order in which the robot had them (arrivals.csv). A recording without
/// that file is gone through by time: at equal times IMU, sonar, pressure, cameras; each arrives
/// when it was measured. Stereo frames are images of both cameras with the same stamp; an image
/// without a partner is left out with a warning. Whatever is malformed is an InputError with file
/// and line.
class EurocReader {
 public:
  /// `folder` is `mav0` or what holds it.
  explicit EurocReader(const std::filesystem::path& folder, const Warn& warn = {});

  const Rig& rig() const { return rig_; }
  /// A file of the recording ("imu0/data.csv"), for messages.
  std::string FileName(const std::string& file) const { return (mav0_ / file).string(); }

  /// How many measurements there are.
  std::size_t size() const { return entries_.size(); }
  bool HasImuSamples() const;
  /// When the robot had the i-th; never decreases.
  Time ArrivalOf(std::size_t i) const { return entries_.at(i).t_arrival; }
  /// The i-th; loads images. InputError for an image that cannot be read or has the wrong size.
  Measurement Read(std::size_t i) const;

  /// The true states; empty where the recording has none. Also reads tables of 8 columns (pose
  /// alone).
  std::vector<StampedTruth> ReadTruth() const;

 private:
  struct FrameFiles {
    std::int64_t index = 0;
    std::array<std::string, 2> names;
  };
  struct Entry {
    Time t;
    Time t_arrival;
    std::variant<ImuSample, FrameFiles, SonarPing, DepthSample> reading;
  };

  void ReadImu();
  void ReadFrames(const Warn& warn);
  void ReadSonar();
  /// Puts the profiles into the pings of entries_.
  void ReadSonarProfiles();
  void ReadDepth();
  void OrderByTime();
  void OrderByArrival(const std::filesystem::path& path);
  /// Which sensor an entry is of: its place among the alternatives of Entry::reading.
  static std::size_t SensorOf(const Entry& entry) { return entry.reading.index(); }
  StereoFrame Load(const FrameFiles& files) const;

  std::filesystem::path mav0_;
  Rig rig_;
  std::vector<Entry> entries_;
};

/// The poses alone.
Trajectory ToTrajectory(const std::vector<StampedTruth>& truth);

}  // namespace drydock::dataset
