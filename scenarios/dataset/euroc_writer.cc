#include "scenarios/dataset/euroc_writer.h"

#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/euroc_layout.h"
#include "scenarios/dataset/rig_yaml.h"
#include "scenarios/dataset/sensor_yaml.h"
#include "sensors_models/base/check.h"

namespace drydock::dataset {
namespace fs = std::filesystem;
namespace {

struct SensorName {
  const char* operator()(const ImuSample&) const { return kImuFolder; }
  const char* operator()(const StereoFrame&) const { return kCameraFolders[0]; }
  const char* operator()(const SonarPing&) const { return kSonarFolder; }
  const char* operator()(const DepthSample&) const { return kPressureFolder; }
};

std::string Join(const Eigen::Vector3d& v) { return fmt::format("{},{},{}", v.x(), v.y(), v.z()); }

std::string ImageName(Time t) { return fmt::format("{}.png", t.ns); }

void WritePng(const fs::path& path, const cv::Mat& image) {
  fs::create_directories(path.parent_path());
  bool written = false;
  try {
    // Image noise has no repeats to look for: coding without is faster and smaller.
    written = cv::imwrite(path.string(), image,
                          {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY,
                           cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY});
  } catch (const cv::Exception& error) {
    RequireInput(false, "{}: cannot be written: {}", path.string(), error.what());
  }
  RequireInput(written, "{}: cannot be written", path.string());
}

/// 16-bit millimetres; 0 for what is not a positive distance below 65.5355 m.
cv::Mat ToMillimetres(const cv::Mat& depth) {
  cv::Mat out(depth.size(), CV_16UC1);
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const float mm = std::round(1000.0F * depth.at<float>(y, x));
      const bool valid = mm > 0.0F && mm <= 65535.0F;
      out.at<std::uint16_t>(y, x) = valid ? static_cast<std::uint16_t>(mm) : 0;
    }
  }
  return out;
}

/// A name that cannot be mistaken for the table's punctuation.
std::string PlainName(std::string_view name) {
  std::string out(name.empty() ? "-" : name);
  for (char& c : out) {
    if (c == ',' || c == '#' || c == '"' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return out;
}

}  // namespace

EurocWriter::EurocWriter(Rig rig, const fs::path& target)
    : rig_(std::move(rig)), directory_(target) {
  tables_[kImuFolder];
  tables_[kCameraFolders[0]];
  tables_[kCameraFolders[1]];
  if (rig_.HasSonar()) tables_[kSonarFolder];
  if (rig_.HasDepth()) tables_[kPressureFolder];
}

fs::path EurocWriter::root() const { return directory_.path() / kRoot; }

void EurocWriter::RequireFree(const std::string& folder, Time t) const {
  const auto table = tables_.find(folder);
  RequireInput(table == tables_.end() || !table->second.contains(t),
               "{}: a second row at {} ns, must have one a time", folder, t.ns);
}

void EurocWriter::AddRow(const std::string& folder, Time t, std::string row) {
  RequireFree(folder, t);
  tables_[folder].emplace(t, std::move(row));
}

void EurocWriter::Add(const Measurement& measurement) {
  const Time t = measurement.t;
  Check(t.ns >= 0 && measurement.t_arrival >= t, "a measurement of {} ns that arrives at {} ns",
        t.ns, measurement.t_arrival.ns);
  const std::string sensor = std::visit(SensorName(), measurement.reading);
  RequireFree(sensor, t);
  const auto* frame = std::get_if<StereoFrame>(&measurement.reading);
  const auto index =
      frame != nullptr ? frame->index : static_cast<std::int64_t>(tables_[sensor].size());
  fmt::format_to(std::back_inserter(arrivals_), "{},{},{},{}\n", t.ns, measurement.t_arrival.ns,
                 sensor, index);
  std::visit([&](const auto& reading) { AddReading(t, reading); }, measurement.reading);
}

void EurocWriter::AddReading(Time t, const ImuSample& sample) {
  AddRow(kImuFolder, t,
         fmt::format("{},{}", Join(sample.angular_rate), Join(sample.specific_force)));
}

void EurocWriter::AddReading(Time t, const StereoFrame& frame) {
  for (std::size_t i = 0; i < 2; ++i) {
    const cv::Mat& image = frame.images[i];
    const CameraIntrinsics& camera = rig_.stereo.cameras[i];
    Check(image.type() == CV_8UC1 || image.type() == CV_8UC3,
          "an image of OpenCV type {}, must be 8-bit grey or BGR", image.type());
    Check(image.cols == camera.width && image.rows == camera.height,
          "an image of {}x{} px from a camera of {}x{} px", image.cols, image.rows, camera.width,
          camera.height);
    WritePng(root() / kCameraFolders[i] / kDataFolder / ImageName(t), image);
    AddRow(kCameraFolders[i], t, ImageName(t));
  }
}

void EurocWriter::AddReading(Time t, const SonarPing& ping) {
  AddRow(kSonarFolder, t,
         fmt::format("{},{},{},{}", ping.range, ping.head_angle, ping.intensity, ping.first_range));
  if (ping.profile.empty()) return;
  Check(std::ssize(ping.profile) == rig_.sonar.bins,
        "an echo profile of {} bins from a sonar of {}", ping.profile.size(), rig_.sonar.bins);
  AddRow(kSonarProfileFolder, t, fmt::format("{}", fmt::join(ping.profile, ",")));
}

void EurocWriter::AddReading(Time t, const DepthSample& sample) {
  AddRow(kPressureFolder, t, fmt::format("{}", sample.depth));
}

void EurocWriter::AddTruth(Time t, const TruthState& state) {
  const auto& q = state.T_WI.q();
  AddRow(kTruthFolder, t,
         fmt::format("{},{},{},{},{},{},{},{}", Join(state.T_WI.p()), q.w(), q.x(), q.y(), q.z(),
                     Join(state.v_W), Join(state.gyro_bias), Join(state.accel_bias)));
}

void EurocWriter::AddSonarTruth(Time t, double range, std::string_view hit) {
  AddRow(kSonarTruthFolder, t, fmt::format("{},{}", range, PlainName(hit)));
}

void EurocWriter::AddDepthImage(std::size_t camera, Time t, const cv::Mat& depth) {
  Check(depth.type() == CV_32FC1, "a depth image of OpenCV type {}, must be CV_32FC1",
        depth.type());
  const char* folder = kDepthImageFolders.at(camera);
  RequireFree(folder, t);
  WritePng(root() / folder / kDataFolder / ImageName(t), ToMillimetres(depth));
  AddRow(folder, t, ImageName(t));
}

void EurocWriter::WriteTable(const std::string& folder, std::string_view header,
                             std::string_view sheet) {
  const auto table = tables_.find(folder);
  if (table == tables_.end()) return;
  std::string out = fmt::format("{}\n", header);
  for (const auto& [t, row] : table->second) {
    fmt::format_to(std::back_inserter(out), "{},{}\n", t.ns, row);
  }
  WriteFileAtomically(root() / folder / kDataFile, out);
  if (!sheet.empty()) WriteFileAtomically(root() / folder / kSensorFile, sheet);
}

void EurocWriter::Commit(AtomicDirectory::IfExists if_exists) {
  for (std::size_t i = 0; i < 2; ++i) {
    fs::create_directories(root() / kCameraFolders[i] / kDataFolder);
    WriteTable(kCameraFolders[i], kCameraHeader, FormatCameraYaml(rig_, i));
    WriteTable(kDepthImageFolders[i], kCameraHeader, FormatDepthImageYaml(rig_, i));
  }
  WriteTable(kImuFolder, kImuHeader, FormatImuYaml(rig_));
  WriteTable(kSonarFolder, kSonarHeader, FormatSonarYaml(rig_));
  WriteTable(kSonarProfileFolder, kSonarProfileHeader, "");
  WriteTable(kSonarTruthFolder, kSonarTruthHeader, "");
  WriteTable(kPressureFolder, kPressureHeader, FormatPressureYaml(rig_));
  WriteTable(kTruthFolder, kTruthHeader, FormatTruthYaml());
  WriteFileAtomically(root() / kBodyFile, FormatBodyYaml(rig_));
  WriteFileAtomically(root() / kRigFile, FormatRig(rig_));
  WriteFileAtomically(root() / kArrivalsFile, fmt::format("{}\n{}", kArrivalsHeader, arrivals_));
  directory_.Commit(if_exists);
}

}  // namespace drydock::dataset
