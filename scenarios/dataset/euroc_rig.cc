#include "scenarios/dataset/euroc_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/dataset/euroc_layout.h"
#include "scenarios/dataset/sensor_yaml.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::dataset {
namespace fs = std::filesystem;
namespace {

constexpr Bounds kRate{0.01, 10'000.0};
constexpr Bounds kNoise{0.0, 1e3};
constexpr Bounds kSmall{0.0, 0.1};
constexpr Bounds kLimit{0.0, 1e6};
/// For recordings that do not say how large an IMU's first bias may be, or how the sonar turns.
constexpr double kGyroTurnOnBias = 0.03;                      ///< [rad/s]
constexpr double kAccelTurnOnBias = 0.1;                      ///< [m/s^2]
constexpr double kHeadStep = 0.9 * std::numbers::pi / 180.0;  ///< [rad]
constexpr double kSameRig = 1e-6;    ///< Relative difference of two values that are the same.
constexpr double kRounding = 1e-12;  ///< Of values that ought to be zero.

/// OpenCV begins its files with a directive that is no YAML; the line is kept for the numbering.
std::string WithoutDirective(std::string text) {
  if (text.starts_with("%YAML")) text[0] = '#';
  return text;
}

/// Reads one sensor.yaml by `read`; what it does not ask for is warned about.
template <typename Read>
void ReadSheet(const fs::path& folder, const Warn& warn, Read read) {
  const fs::path path = folder / kSensorFile;
  const YamlNode root = ParseYaml(WithoutDirective(ReadFile(path, 1 << 20)), path.string());
  YamlReader yaml(root);
  yaml.Skip("comment");
  read(yaml);
  yaml.Finish(warn);
}

void RequireType(YamlReader& yaml, const std::string& type) {
  yaml.Choice("sensor_type", {type}, type);
}

/// The sensor's frame to the recording's body.
Pose ReadMounting(YamlReader& yaml) {
  Pose mounting;
  yaml.Map("T_BS", [&](YamlReader& matrix) {
    matrix.Integer("cols", {4, 4}, 4);
    matrix.Integer("rows", {4, 4}, 4);
    const std::vector<double> v = matrix.Reals("data", {-1e6, 1e6}, 16);
    const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> T(v.data());
    const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
    const bool is_rotation =
        (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && R.determinant() > 0.0;
    const bool is_rigid = T.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
    if (!is_rotation || !is_rigid) matrix.Fail("data", "a rotation, a translation and 0 0 0 1");
    mounting = Pose(Eigen::Quaterniond(R), T.topRightCorner<3, 1>());
  });
  return mounting;
}

CameraIntrinsics ReadOptics(YamlReader& yaml) {
  CameraIntrinsics camera;
  const std::vector<double> size = yaml.Reals("resolution", {16, 8192}, 2);
  if (size[0] != std::floor(size[0]) || size[1] != std::floor(size[1])) {
    yaml.Fail("resolution", "width and height in whole pixels");
  }
  yaml.Choice("camera_model", {"pinhole"}, "pinhole");
  const std::string radtan = DistortionModel(LensModel::kRadtan);
  const std::string equidistant = DistortionModel(LensModel::kEquidistant);
  camera.lens = yaml.Choice("distortion_model", {radtan, equidistant}, radtan) == equidistant
                    ? LensModel::kEquidistant
                    : LensModel::kRadtan;
  const std::vector<double> k = yaml.Reals("intrinsics", {0.0, 1e5}, 4);
  if (k[0] < 1.0 || k[1] < 1.0) yaml.Fail("intrinsics", "[fu, fv, cu, cv] with fu and fv above 1");
  const double largest = LargestDistortion(camera.lens);
  const std::vector<double> distortion =
      yaml.Reals("distortion_coefficients", {-largest, largest}, 4);
  camera.width = static_cast<int>(size[0]);
  camera.height = static_cast<int>(size[1]);
  camera.fx = k[0];
  camera.fy = k[1];
  camera.cx = k[2];
  camera.cy = k[3];
  std::copy(distortion.begin(), distortion.end(), camera.distortion.begin());
  return camera;
}

/// Mountings below are of the recording's body B until ReadSheets() makes them of the IMU.
void ReadCamera(const fs::path& mav0, std::size_t i, const Warn& warn, StereoSheet& stereo) {
  ReadSheet(mav0 / kCameraFolders[i], warn, [&](YamlReader& yaml) {
    RequireType(yaml, "camera");
    stereo.T_IC[i] = ReadMounting(yaml);
    const double rate = yaml.Real("rate_hz", kRate);
    stereo.cameras[i] = ReadOptics(yaml);
    if (i == 0) {
      stereo.rate_hz = rate;
      return;
    }
    const bool same_size = stereo.cameras[0].width == stereo.cameras[1].width &&
                           stereo.cameras[0].height == stereo.cameras[1].height;
    if (!same_size) yaml.Fail("resolution", "that of cam0");
    if (rate != stereo.rate_hz) yaml.Fail("rate_hz", "that of cam0");
  });
}

Pose ReadImu(const fs::path& mav0, const Warn& warn, ImuSheet& imu) {
  Pose T_BI;
  ReadSheet(mav0 / kImuFolder, warn, [&](YamlReader& yaml) {
    RequireType(yaml, "imu");
    T_BI = ReadMounting(yaml);
    imu.rate_hz = yaml.Real("rate_hz", kRate);
    imu.gyro_noise_density = yaml.Real("gyroscope_noise_density", kNoise);
    imu.gyro_bias_walk = yaml.Real("gyroscope_random_walk", kNoise);
    imu.accel_noise_density = yaml.Real("accelerometer_noise_density", kNoise);
    imu.accel_bias_walk = yaml.Real("accelerometer_random_walk", kNoise);
    imu.gyro_turn_on_bias = yaml.Real("gyroscope_turn_on_bias", kNoise, kGyroTurnOnBias);
    imu.accel_turn_on_bias = yaml.Real("accelerometer_turn_on_bias", kNoise, kAccelTurnOnBias);
    imu.gyro_scale_error = yaml.Real("gyroscope_scale_error", kSmall, 0.0);
    imu.accel_scale_error = yaml.Real("accelerometer_scale_error", kSmall, 0.0);
    imu.gyro_misalignment = yaml.Real("gyroscope_misalignment", kSmall, 0.0);
    imu.accel_misalignment = yaml.Real("accelerometer_misalignment", kSmall, 0.0);
    imu.gyro_range = yaml.Real("gyroscope_range", kLimit, 0.0);
    imu.accel_range = yaml.Real("accelerometer_range", kLimit, 0.0);
    imu.gyro_resolution = yaml.Real("gyroscope_resolution", kNoise, 0.0);
    imu.accel_resolution = yaml.Real("accelerometer_resolution", kNoise, 0.0);
  });
  return T_BI;
}

void ReadSonar(const fs::path& mav0, const Warn& warn, SonarSheet& sonar) {
  ReadSheet(mav0 / kSonarFolder, warn, [&](YamlReader& yaml) {
    RequireType(yaml, "profiling_sonar");
    sonar.T_IS = ReadMounting(yaml);
    sonar.rate_hz = yaml.Real("rate_hz", kRate);
    sonar.min_range_m = yaml.Real("min_range", {0.0, 1e3}, 0.0);
    sonar.max_range_m = yaml.Real("max_range", {0.01, 1e3});
    if (sonar.max_range_m <= sonar.min_range_m) yaml.Fail("max_range", "more than min_range");
    sonar.range_noise_m = yaml.Real("range_resolution", kNoise);
    sonar.step_rad = yaml.Real("head_step", {1e-4, 3.2}, kHeadStep);
    sonar.beam_width_rad = yaml.Real("beam_width", {0.0, 0.8}, 0.0);
    sonar.bins = static_cast<int>(yaml.Integer("bins", {0, 4096}, 0));
    sonar.intensity_floor = yaml.Real("intensity_floor", {0.0, 1.0}, 0.0);
  });
}

void ReadPressure(const fs::path& mav0, const Warn& warn, const Pose& T_BI, DepthSheet& depth) {
  ReadSheet(mav0 / kPressureFolder, warn, [&](YamlReader& yaml) {
    RequireType(yaml, "pressure");
    depth.p_ID = (T_BI.Inverse() * ReadMounting(yaml)).p();
    depth.rate_hz = yaml.Real("rate_hz", kRate);
    depth.noise_m = yaml.Real("depth_noise", kNoise);
    depth.offset_m = yaml.Real("depth_offset", kNoise, 0.0);
    depth.lag_s = yaml.Real("depth_lag", {0.0, 60.0}, 0.0);
    depth.resolution_m = yaml.Real("depth_resolution", kNoise, 0.0);
  });
}

Rig ReadSheets(const fs::path& mav0, const Warn& warn) {
  Rig rig;
  const fs::path recording = fs::absolute(mav0).lexically_normal();
  rig.name = recording.parent_path().filename().string();
  if (rig.name.empty()) rig.name = "euroc";
  const Pose T_BI = ReadImu(mav0, warn, rig.imu);
  for (std::size_t i = 0; i < 2; ++i) {
    ReadCamera(mav0, i, warn, rig.stereo);
    rig.stereo.T_IC[i] = T_BI.Inverse() * rig.stereo.T_IC[i];
  }
  if (fs::exists(mav0 / kSonarFolder)) {
    ReadSonar(mav0, warn, rig.sonar);
    rig.sonar.T_IS = T_BI.Inverse() * rig.sonar.T_IS;
  }
  if (fs::exists(mav0 / kPressureFolder)) ReadPressure(mav0, warn, T_BI, rig.depth);
  return rig;
}

/// All numbers of a rig in a fixed order, those of each sensor together.
struct Numbers {
  const char* sensor;
  std::vector<double> values;
};

void Append(std::vector<double>& values, const Pose& pose) {
  const Eigen::Matrix3d R = pose.R();
  values.insert(values.end(), R.data(), R.data() + 9);
  values.insert(values.end(), pose.p().data(), pose.p().data() + 3);
}

std::vector<Numbers> NumbersOf(const Rig& rig) {
  std::vector<Numbers> all;
  for (std::size_t i = 0; i < 2; ++i) {
    const CameraIntrinsics& c = rig.stereo.cameras[i];
    Numbers camera{kCameraFolders[i],
                   {rig.stereo.rate_hz, static_cast<double>(c.width), static_cast<double>(c.height),
                    c.fx, c.fy, c.cx, c.cy, static_cast<double>(c.lens)}};
    camera.values.insert(camera.values.end(), c.distortion.begin(), c.distortion.end());
    Append(camera.values, rig.stereo.T_IC[i]);
    all.push_back(std::move(camera));
  }
  const ImuSheet& imu = rig.imu;
  all.push_back(
      {kImuFolder,
       {imu.rate_hz, imu.gyro_noise_density, imu.accel_noise_density, imu.gyro_bias_walk,
        imu.accel_bias_walk, imu.gyro_turn_on_bias, imu.accel_turn_on_bias, imu.gyro_scale_error,
        imu.accel_scale_error, imu.gyro_misalignment, imu.accel_misalignment, imu.gyro_range,
        imu.accel_range, imu.gyro_resolution, imu.accel_resolution}});
  const SonarSheet& sonar = rig.sonar;
  Numbers pings{
      kSonarFolder,
      {sonar.rate_hz, sonar.step_rad, sonar.min_range_m, sonar.max_range_m, sonar.range_noise_m,
       sonar.beam_width_rad, static_cast<double>(sonar.bins), sonar.intensity_floor}};
  Append(pings.values, sonar.T_IS);
  all.push_back(std::move(pings));
  const DepthSheet& depth = rig.depth;
  all.push_back({kPressureFolder,
                 {depth.rate_hz, depth.noise_m, depth.offset_m, depth.lag_s, depth.resolution_m,
                  depth.p_ID.x(), depth.p_ID.y(), depth.p_ID.z()}});
  return all;
}

void RequireSame(const Rig& ours, const Rig& sheets, const fs::path& mav0) {
  const std::vector<Numbers> a = NumbersOf(ours);
  const std::vector<Numbers> b = NumbersOf(sheets);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].values.size(); ++k) {
      const double allowed = kRounding + kSameRig * std::abs(a[i].values[k]);
      RequireInput(std::abs(a[i].values[k] - b[i].values[k]) <= allowed,
                   "{}: does not say the same of {} as {}: change both, or remove {} to go by the "
                   "sensor.yaml files",
                   (mav0 / kRigFile).string(), a[i].sensor,
                   (mav0 / a[i].sensor / kSensorFile).string(), kRigFile);
    }
  }
}

}  // namespace

Rig ReadEurocRig(const fs::path& mav0, const Warn& warn) {
  Rig sheets = ReadSheets(mav0, warn);
  if (!fs::exists(mav0 / kRigFile)) return sheets;
  Rig rig = LoadRig(mav0 / kRigFile);
  RequireSame(rig, sheets, mav0);
  return rig;
}

}  // namespace drydock::dataset
