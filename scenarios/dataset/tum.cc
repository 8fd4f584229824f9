#include "scenarios/dataset/tum.h"

#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "scenarios/dataset/parse.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock::dataset {
namespace {

constexpr std::size_t kColumns = 8;
constexpr std::array<std::string_view, kColumns> kNames = {"t",  "tx", "ty", "tz",
                                                           "qx", "qy", "qz", "qw"};

/// Where a message points to.
struct Place {
  const std::string& file;
  int line;

  std::string ToString() const { return fmt::format("{}:{}", file, line); }
};

/// The fields of a line, and how many there are.
struct Fields {
  std::array<std::string_view, kColumns> text;
  std::size_t count = 0;
};

Fields Split(std::string_view line) {
  Fields fields;
  while (true) {
    line = Trim(line);
    if (line.empty()) return fields;
    const auto end = std::min(line.find_first_of(" \t"), line.size());
    if (fields.count < kColumns) fields.text[fields.count] = line.substr(0, end);
    ++fields.count;
    line.remove_prefix(end);
  }
}

StampedPose ParsePose(const Fields& fields, const Place& place) {
  RequireInput(fields.count == kColumns,
               "{}: {} values, must be 8 between blanks: t tx ty tz qx qy qz qw", place.ToString(),
               fields.count);
  const auto time = ParseSeconds(fields.text[0]);
  RequireInput(time.has_value(), "{}: t is {}, must be a number of seconds within ±{}",
               place.ToString(), Quoted(fields.text[0]), kLastSecond);
  std::array<double, kColumns> v{};
  for (std::size_t i = 1; i < kColumns; ++i) {
    const auto value = ParseReal(fields.text[i]);
    RequireInput(value && std::abs(*value) <= kLargest, "{}: {} is {}, must be {}",
                 place.ToString(), kNames[i], Quoted(fields.text[i]), kWithinLargest);
    v[i] = *value;
  }
  const Eigen::Quaterniond q(v[7], v[4], v[5], v[6]);
  RequireInput(std::abs(q.norm() - 1.0) <= 1e-3,
               "{}: the quaternion's length is {}, must be 1 to within 1e-3", place.ToString(),
               q.norm());
  return {*time, Pose(q, Eigen::Vector3d(v[1], v[2], v[3]))};
}

}  // namespace

Trajectory ParseTum(std::string_view text, const std::string& file) {
  Trajectory trajectory;
  LineReader lines(text);
  while (const auto line = lines.Next()) {
    const std::string_view content = Trim(*line);
    if (content.empty() || content.starts_with('#')) continue;
    const Place place{file, lines.number()};
    const StampedPose pose = ParsePose(Split(content), place);
    RequireInput(trajectory.empty() || pose.t > trajectory.back().t,
                 "{}: t is {}, must be later than the {} before it", place.ToString(),
                 FormatSeconds(pose.t),
                 trajectory.empty() ? "" : FormatSeconds(trajectory.back().t));
    trajectory.push_back(pose);
  }
  return trajectory;
}

Trajectory ReadTum(const std::filesystem::path& path) {
  return ParseTum(ReadFile(path), path.string());
}

std::string FormatTum(const Trajectory& trajectory) {
  std::string out = "# timestamp tx ty tz qx qy qz qw\n";
  for (const auto& [t, T_WI] : trajectory) {
    const auto& p = T_WI.p();
    const auto& q = T_WI.q();
    fmt::format_to(std::back_inserter(out),
                   "{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", FormatSeconds(t),
                   p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  }
  return out;
}

void WriteTum(const std::filesystem::path& path, const Trajectory& trajectory) {
  WriteFileAtomically(path, FormatTum(trajectory));
}

}  // namespace drydock::dataset
