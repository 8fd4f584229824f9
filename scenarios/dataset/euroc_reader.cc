#include "scenarios/dataset/euroc_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/euroc_layout.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock::dataset {
namespace fs = std::filesystem;
namespace {

/// Names of sensors in arrivals.csv, in the order of Entry::reading's alternatives.
constexpr std::array<const char*, 4> kSensorNames = {kImuFolder, kCameraFolders[0], kSonarFolder,
                                                     kPressureFolder};

/// Which goes first where times are equal: IMU, sonar, pressure, cameras.
constexpr std::array<int, 4> kOrderAtEqualTimes = {0, 3, 1, 2};

fs::path FindRoot(const fs::path& folder) {
  RequireInput(fs::exists(folder), "{}: no such folder", folder.string());
  if (fs::is_directory(folder / kRoot)) return folder / kRoot;
  RequireInput(fs::is_directory(folder / kImuFolder),
               "{}: no recording in EuRoC's layout: neither '{}' nor '{}' is in it",
               folder.string(), kRoot, kImuFolder);
  return folder;
}

/// Calls `read` for each row of a table.
template <typename Read>
void ForEachRow(const fs::path& path, std::vector<std::string> columns, Read read,
                std::size_t required = 0) {
  const std::string text = ReadFile(path, std::size_t{1} << 32);
  CsvReader csv(text, path.string(), std::move(columns), required);
  while (csv.Next()) read(csv);
}

Eigen::Vector3d ReadVector(const CsvReader& csv, std::size_t first) {
  return {csv.Real(first), csv.Real(first + 1), csv.Real(first + 2)};
}

std::map<Time, std::string> ReadImageNames(const fs::path& folder) {
  std::map<Time, std::string> names;
  ForEachRow(folder / kDataFile, {"timestamp", "filename"}, [&](CsvReader& csv) {
    const Time t = csv.IncreasingStamp(0);
    names.emplace_hint(names.end(), t, csv.FileName(1));
  });
  return names;
}

/// Width and height as the head of a PNG has them; nothing for other formats.
std::optional<cv::Size> SizeOfPng(const std::string& bytes) {
  constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
  constexpr std::size_t kWidthAt = 16;  // Behind the signature, a chunk's length and its name.
  if (!bytes.starts_with(kSignature) || bytes.size() < kWidthAt + 8) return std::nullopt;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return static_cast<int>(std::min<std::uint32_t>(value, std::numeric_limits<int>::max()));
  };
  return cv::Size(number(kWidthAt), number(kWidthAt + 4));
}

void RequireSize(const cv::Size& size, const CameraIntrinsics& camera, const fs::path& path) {
  RequireInput(size.width == camera.width && size.height == camera.height,
               "{}: is {}x{} px, must be {}x{} as sensor.yaml says", path.string(), size.width,
               size.height, camera.width, camera.height);
}

cv::Mat LoadImage(const fs::path& path, const CameraIntrinsics& camera) {
  const std::string bytes = ReadFile(path);
  // Before it is unpacked: a few bytes can claim gigabytes.
  if (const auto size = SizeOfPng(bytes)) RequireSize(*size, camera, path);
  cv::Mat image;
  try {
    const std::vector<unsigned char> buffer(bytes.begin(), bytes.end());
    if (!buffer.empty()) image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  RequireInput(!image.empty(), "{}: an image that cannot be read", path.string());
  return image;
}

}  // namespace

EurocReader::EurocReader(const fs::path& folder, const Warn& warn) : mav0_(FindRoot(folder)) {
  const Warn say = warn ? warn : [](const std::string&) {};
  rig_ = ReadEurocRig(mav0_, say);
  ReadImu();
  ReadFrames(say);
  if (rig_.HasSonar()) ReadSonar();
  if (rig_.HasDepth()) ReadDepth();
  const fs::path arrivals = mav0_ / kArrivalsFile;
  if (fs::exists(arrivals)) {
    OrderByArrival(arrivals);
  } else {
    OrderByTime();
  }
}

void EurocReader::ReadImu() {
  ForEachRow(mav0_ / kImuFolder / kDataFile,
             {"timestamp", "w_RS_S_x", "w_RS_S_y", "w_RS_S_z", "a_RS_S_x", "a_RS_S_y", "a_RS_S_z"},
             [&](CsvReader& csv) {
               const Time t = csv.IncreasingStamp(0);
               entries_.push_back({t, t, ImuSample{ReadVector(csv, 1), ReadVector(csv, 4)}});
             });
}

void EurocReader::ReadFrames(const Warn& warn) {
  const std::map<Time, std::string> left = ReadImageNames(mav0_ / kCameraFolders[0]);
  const std::map<Time, std::string> right = ReadImageNames(mav0_ / kCameraFolders[1]);
  std::int64_t index = 0;
  for (const auto& [t, name] : left) {
    const auto partner = right.find(t);
    if (partner == right.end()) continue;
    entries_.push_back({t, t, FrameFiles{index++, {name, partner->second}}});
  }
  const auto pairs = static_cast<std::size_t>(index);
  const std::size_t alone = left.size() + right.size() - 2 * pairs;
  if (alone > 0) {
    warn(
        fmt::format("{}: {} images without a partner of the same time in the other camera are "
                    "left out; {} pairs remain",
                    mav0_.string(), alone, pairs));
  }
}

void EurocReader::ReadSonar() {
  constexpr std::size_t kFirstRange = 4;  // Recordings of others may lack it.
  const auto read = [&](CsvReader& csv) {
    const Time t = csv.IncreasingStamp(0);
    SonarPing ping;
    ping.range = csv.Real(1);
    ping.head_angle = csv.Real(2);
    ping.intensity = csv.Real(3);
    ping.first_range = csv.size() > kFirstRange ? csv.Real(kFirstRange) : ping.range;
    if (ping.range < 0.0) csv.Fail(1, "at least 0");
    if (ping.first_range < 0.0) csv.Fail(kFirstRange, "at least 0");
    entries_.push_back({t, t, std::move(ping)});
  };
  ForEachRow(mav0_ / kSonarFolder / kDataFile,
             {"timestamp", "range", "head_position", "intensity", "first_range"}, read,
             kFirstRange);
  if (fs::exists(mav0_ / kSonarProfileFolder)) ReadSonarProfiles();
}

void EurocReader::ReadSonarProfiles() {
  std::map<Time, SonarPing*> pings;
  for (Entry& entry : entries_) {
    if (auto* ping = std::get_if<SonarPing>(&entry.reading)) pings[entry.t] = ping;
  }
  std::vector<std::string> columns = {"timestamp"};
  for (int bin = 0; bin < rig_.sonar.bins; ++bin) columns.push_back(fmt::format("bin {}", bin));
  ForEachRow(mav0_ / kSonarProfileFolder / kDataFile, columns, [&](CsvReader& csv) {
    const auto ping = pings.find(csv.IncreasingStamp(0));
    if (ping == pings.end()) csv.Fail(0, "the time of a ping of sonar0/data.csv");
    for (std::size_t column = 1; column < csv.size(); ++column) {
      const std::int64_t amplitude = csv.Integer(column);
      if (amplitude < 0 || amplitude > 255) csv.Fail(column, "from 0 to 255");
      ping->second->profile.push_back(static_cast<std::uint8_t>(amplitude));
    }
  });
}

void EurocReader::ReadDepth() {
  ForEachRow(mav0_ / kPressureFolder / kDataFile, {"timestamp", "depth"}, [&](CsvReader& csv) {
    const Time t = csv.IncreasingStamp(0);
    entries_.push_back({t, t, DepthSample{csv.Real(1)}});
  });
}

void EurocReader::OrderByTime() {
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.t, kOrderAtEqualTimes[SensorOf(a)]) <
           std::tie(b.t, kOrderAtEqualTimes[SensorOf(b)]);
  });
}

void EurocReader::OrderByArrival(const fs::path& path) {
  std::map<std::pair<std::size_t, Time>, std::size_t> by_stamp;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    by_stamp[{SensorOf(entries_[i]), entries_[i].t}] = i;
  }
  std::vector<Entry> ordered;
  ForEachRow(path, {"timestamp", "arrival", "sensor", "index"}, [&](CsvReader& csv) {
    const auto name = std::find(kSensorNames.begin(), kSensorNames.end(), csv.Text(2));
    if (name == kSensorNames.end()) csv.Fail(2, "imu0, cam0, sonar0 or pressure0");
    const auto sensor = static_cast<std::size_t>(name - kSensorNames.begin());
    const auto found = by_stamp.find({sensor, csv.Stamp(0)});
    if (found == by_stamp.end()) {
      csv.Fail(0, fmt::format("the time of a row of {}/{}, each once", *name, kDataFile));
    }
    Entry entry = std::move(entries_[found->second]);
    by_stamp.erase(found);
    entry.t_arrival = csv.Stamp(1);
    if (entry.t_arrival < entry.t) csv.Fail(1, "at least the timestamp");
    if (!ordered.empty() && entry.t_arrival < ordered.back().t_arrival)
      csv.Fail(1, fmt::format("at least the {} before it", ordered.back().t_arrival.ns));
    const std::int64_t index = csv.Integer(3);
    if (auto* files = std::get_if<FrameFiles>(&entry.reading)) files->index = index;
    ordered.push_back(std::move(entry));
  });
  RequireInput(by_stamp.empty(), "{}: {} measurements never arrive, first {} at {}", path.string(),
               by_stamp.size(),
               by_stamp.empty() ? "" : kSensorNames.at(by_stamp.begin()->first.first),
               by_stamp.empty() ? 0 : by_stamp.begin()->first.second.ns);
  entries_ = std::move(ordered);
}

StereoFrame EurocReader::Load(const FrameFiles& files) const {
  StereoFrame frame;
  frame.index = files.index;
  for (std::size_t i = 0; i < 2; ++i) {
    const fs::path path = mav0_ / kCameraFolders[i] / kDataFolder / files.names[i];
    const CameraIntrinsics& camera = rig_.stereo.cameras[i];
    frame.images[i] = LoadImage(path, camera);
    const cv::Mat& image = frame.images[i];
    RequireInput(image.type() == CV_8UC1 || image.type() == CV_8UC3,
                 "{}: must be an 8-bit grey or colour image", path.string());
    RequireSize(image.size(), camera, path);
  }
  return frame;
}

bool EurocReader::HasImuSamples() const {
  return std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return std::holds_alternative<ImuSample>(entry.reading);
  });
}

Measurement EurocReader::Read(std::size_t i) const {
  const Entry& entry = entries_.at(i);
  Measurement measurement;
  measurement.t = entry.t;
  measurement.t_arrival = entry.t_arrival;
  std::visit(
      [&](const auto& reading) {
        if constexpr (std::is_same_v<std::decay_t<decltype(reading)>, FrameFiles>) {
          measurement.reading = Load(reading);
        } else {
          measurement.reading = reading;
        }
      },
      entry.reading);
  return measurement;
}

std::vector<StampedTruth> EurocReader::ReadTruth() const {
  constexpr std::size_t kPoseColumns = 8;
  std::vector<StampedTruth> truth;
  const fs::path path = mav0_ / kTruthFolder / kDataFile;
  if (!fs::exists(path)) return truth;
  std::vector<std::string> columns = {"timestamp", "p_x",   "p_y",   "p_z",   "q_w",  "q_x",
                                      "q_y",       "q_z",   "v_x",   "v_y",   "v_z",  "b_w_x",
                                      "b_w_y",     "b_w_z", "b_a_x", "b_a_y", "b_a_z"};
  const auto read = [&](CsvReader& csv) {
    StampedTruth row;
    row.t = csv.IncreasingStamp(0);
    const Eigen::Quaterniond q(csv.Real(4), csv.Real(5), csv.Real(6), csv.Real(7));
    RequireInput(std::abs(q.norm() - 1.0) <= 1e-3,
                 "{}: the quaternion's length is {}, must be 1 to within 1e-3", csv.Place(),
                 q.norm());
    row.state.T_WI = Pose(q, ReadVector(csv, 1));
    RequireInput(csv.size() == kPoseColumns || csv.size() == columns.size(),
                 "{}: {} fields, must be 8 or 17", csv.Place(), csv.size());
    row.pose_only = csv.size() == kPoseColumns;
    if (!row.pose_only) {
      row.state.v_W = ReadVector(csv, 8);
      row.state.gyro_bias = ReadVector(csv, 11);
      row.state.accel_bias = ReadVector(csv, 14);
    }
    truth.push_back(row);
  };
  ForEachRow(path, columns, read, kPoseColumns);
  return truth;
}

Trajectory ToTrajectory(const std::vector<StampedTruth>& truth) {
  Trajectory trajectory;
  for (const StampedTruth& row : truth) trajectory.push_back({row.t, row.state.T_WI});
  return trajectory;
}

}  // namespace drydock::dataset
