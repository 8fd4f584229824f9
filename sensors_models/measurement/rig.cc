#include "sensors_models/measurement/rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/ranges.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/resources.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock {
namespace {

constexpr Bounds kRate{0.01, 10'000.0};
constexpr Bounds kOffset{-10.0, 10.0};
constexpr Bounds kNoise{0.0, 1e3};
constexpr Bounds kSmall{0.0, 0.1};  // What a sheet gives to first order: shares and angles.
constexpr Bounds kLimit{0.0, 1e6};

Eigen::Quaterniond ReadQuaternion(YamlReader& yaml) {
  const std::vector<double> q = yaml.Reals("quaternion_xyzw", {-1.0, 1.0}, 4);
  const Eigen::Quaterniond quaternion(q[3], q[0], q[1], q[2]);
  if (std::abs(quaternion.norm() - 1.0) > 1e-3) yaml.Fail("quaternion_xyzw", "of length 1");
  return quaternion;  // Pose normalises.
}

Pose ReadMounting(YamlReader& yaml) {
  const Eigen::Vector3d position = yaml.Vector3("position_m", kOffset);
  return {ReadQuaternion(yaml), position};
}

/// By the key that its coefficients stand under.
LensModel ReadLens(YamlReader& yaml) {
  const std::string radtan = LensKey(LensModel::kRadtan);
  const std::string equidistant = LensKey(LensModel::kEquidistant);
  yaml.Skip(radtan);
  yaml.Skip(equidistant);
  RequireInput(yaml.Has(radtan) || yaml.Has(equidistant),
               "{}: a camera needs one of the keys '{}' and '{}'", yaml.Place(), radtan,
               equidistant);
  if (!yaml.Has(equidistant)) return LensModel::kRadtan;
  if (yaml.Has(radtan)) yaml.Fail(equidistant, "left out beside radtan: a camera has one lens");
  return LensModel::kEquidistant;
}

CameraIntrinsics ReadIntrinsics(YamlReader& yaml) {
  CameraIntrinsics camera;
  camera.width = static_cast<int>(yaml.Integer("width_px", {16, 8192}));
  camera.height = static_cast<int>(yaml.Integer("height_px", {16, 8192}));
  const auto focal = yaml.Reals("focal_px", {1.0, 1e5}, 2);
  const auto centre = yaml.Reals("principal_point_px", {0.0, 8192.0}, 2);
  camera.lens = ReadLens(yaml);
  const double largest = LargestDistortion(camera.lens);
  const auto distortion = yaml.Reals(LensKey(camera.lens), {-largest, largest}, 4);
  camera.fx = focal[0];
  camera.fy = focal[1];
  camera.cx = centre[0];
  camera.cy = centre[1];
  std::copy(distortion.begin(), distortion.end(), camera.distortion.begin());
  return camera;
}

ImagerSheet ReadImager(YamlReader& yaml) {
  ImagerSheet imager;
  imager.gamma = yaml.Real("gamma", {0.5, 4.0}, imager.gamma);
  imager.sensitivity_per_s = yaml.Real("sensitivity_per_s", {1e-3, 1e6}, imager.sensitivity_per_s);
  imager.shutter_max_s = yaml.Real("shutter_max_s", {1e-6, 1.0}, imager.shutter_max_s);
  imager.gain_max_db = yaml.Real("gain_max_db", {0.0, 60.0}, imager.gain_max_db);
  imager.auto_exposure_target =
      yaml.Real("auto_exposure_target", {0.01, 0.9}, imager.auto_exposure_target);
  imager.auto_exposure_time_s =
      yaml.Real("auto_exposure_time_s", {0.0, 60.0}, imager.auto_exposure_time_s);
  imager.full_well_e = yaml.Real("full_well_e", {0.0, 1e7}, imager.full_well_e);
  imager.read_noise_e = yaml.Real("read_noise_e", {0.0, 1e4}, imager.read_noise_e);
  imager.vignetting = yaml.Real("vignetting", {0.0, 2.0}, imager.vignetting);
  if (imager.read_noise_e > 0.0 && imager.full_well_e == 0.0)
    yaml.Fail("read_noise_e", "0 without full_well_e");
  return imager;
}

StereoSheet ReadStereo(YamlReader& yaml) {
  StereoSheet stereo;
  stereo.rate_hz = yaml.Real("rate_hz", kRate);
  yaml.OptionalMap("imager", [&](YamlReader& imager) { stereo.imager = ReadImager(imager); });
  std::size_t count = 0;
  yaml.List("cameras", [&](YamlReader& camera) {
    if (count >= 2) camera.Fail("position_m", "that of one of two cameras");
    stereo.T_IC[count] = ReadMounting(camera);
    stereo.cameras[count] = ReadIntrinsics(camera);
    ++count;
  });
  if (count != 2) yaml.Fail("cameras", "a list of two cameras, left and right");
  const bool same_size = stereo.cameras[0].width == stereo.cameras[1].width &&
                         stereo.cameras[0].height == stereo.cameras[1].height;
  if (!same_size) yaml.Fail("cameras", "a list of two cameras with images of the same size");
  return stereo;
}

ImuSheet ReadImu(YamlReader& yaml) {
  ImuSheet imu;
  imu.rate_hz = yaml.Real("rate_hz", kRate);
  imu.gyro_noise_density = yaml.Real("gyro_noise_density_rad_s_sqrthz", kNoise);
  imu.accel_noise_density = yaml.Real("accel_noise_density_m_s2_sqrthz", kNoise);
  imu.gyro_bias_walk = yaml.Real("gyro_bias_walk_rad_s2_sqrthz", kNoise);
  imu.accel_bias_walk = yaml.Real("accel_bias_walk_m_s3_sqrthz", kNoise);
  imu.gyro_turn_on_bias = yaml.Real("gyro_turn_on_bias_rad_s", kNoise);
  imu.accel_turn_on_bias = yaml.Real("accel_turn_on_bias_m_s2", kNoise);
  imu.gyro_scale_error = yaml.Real("gyro_scale_error", kSmall, 0.0);
  imu.accel_scale_error = yaml.Real("accel_scale_error", kSmall, 0.0);
  imu.gyro_misalignment = yaml.Real("gyro_misalignment_rad", kSmall, 0.0);
  imu.accel_misalignment = yaml.Real("accel_misalignment_rad", kSmall, 0.0);
  imu.gyro_range = yaml.Real("gyro_range_rad_s", kLimit, 0.0);
  imu.accel_range = yaml.Real("accel_range_m_s2", kLimit, 0.0);
  imu.gyro_resolution = yaml.Real("gyro_resolution_rad_s", kNoise, 0.0);
  imu.accel_resolution = yaml.Real("accel_resolution_m_s2", kNoise, 0.0);
  if (imu.gyro_range > 0.0 && imu.gyro_resolution > imu.gyro_range) {
    yaml.Fail("gyro_resolution_rad_s", "at most gyro_range_rad_s");
  }
  if (imu.accel_range > 0.0 && imu.accel_resolution > imu.accel_range) {
    yaml.Fail("accel_resolution_m_s2", "at most accel_range_m_s2");
  }
  return imu;
}

void ReadEcho(YamlReader& yaml, SonarSheet& sonar) {
  const SonarSheet defaults;
  sonar.beam_width_rad = yaml.Real("beam_width_deg", {0.0, 45.0}, 0.0) * std::numbers::pi / 180.0;
  sonar.bins = static_cast<int>(yaml.Integer("bins", {0, 4096}, defaults.bins));
  sonar.pulse_length_s = yaml.Real("pulse_length_s", {0.0, 1e-2}, defaults.pulse_length_s);
  sonar.incidence_exponent =
      yaml.Real("incidence_exponent", {1.0, 20.0}, defaults.incidence_exponent);
  sonar.absorption_db_m = yaml.Real("absorption_db_m", {0.0, 100.0}, defaults.absorption_db_m);
  sonar.gain_absorption_db_m =
      yaml.Real("gain_absorption_db_m", {0.0, 100.0}, defaults.gain_absorption_db_m);
  sonar.speckle_looks =
      static_cast<int>(yaml.Integer("speckle_looks", {0, 64}, defaults.speckle_looks));
  sonar.noise_floor = yaml.Real("noise_floor", {0.0, 1.0}, defaults.noise_floor);
  sonar.dropout_probability =
      yaml.Real("dropout_probability", {0.0, 1.0}, defaults.dropout_probability);
  sonar.intensity_floor = yaml.Real("intensity_floor", {0.0, 1.0}, defaults.intensity_floor);
}

SonarSheet ReadSonar(YamlReader& yaml) {
  SonarSheet sonar;
  sonar.rate_hz = yaml.Real("rate_hz", kRate);
  sonar.T_IS = ReadMounting(yaml);
  sonar.step_rad = yaml.Real("step_deg", {0.01, 180.0}) * std::numbers::pi / 180.0;
  sonar.min_range_m = yaml.Real("min_range_m", {0.0, 1e3});
  sonar.max_range_m = yaml.Real("max_range_m", {0.01, 1e3});
  sonar.range_noise_m = yaml.Real("range_noise_m", kNoise);
  ReadEcho(yaml, sonar);
  if (sonar.max_range_m <= sonar.min_range_m) yaml.Fail("max_range_m", "more than min_range_m");
  return sonar;
}

DepthSheet ReadDepth(YamlReader& yaml) {
  DepthSheet depth;
  depth.rate_hz = yaml.Real("rate_hz", kRate);
  depth.p_ID = yaml.Vector3("position_m", kOffset);
  depth.noise_m = yaml.Real("noise_m", kNoise);
  depth.offset_m = yaml.Real("offset_m", kNoise, 0.0);
  depth.lag_s = yaml.Real("lag_s", {0.0, 60.0}, 0.0);
  depth.resolution_m = yaml.Real("resolution_m", kNoise, 0.0);
  return depth;
}

std::filesystem::path RigFolder() {
  return DataDirectory() / "sensors_models" / "measurement" / "rigs";
}

}  // namespace

std::string LensKey(LensModel lens) {
  return lens == LensModel::kRadtan ? "radtan" : "equidistant";
}

double LargestDistortion(LensModel lens) { return lens == LensModel::kRadtan ? 2.0 : 20.0; }

Rig ReadRig(const YamlNode& root) {
  return ReadYaml(root, [](YamlReader& yaml) {
    Rig rig;
    rig.name = yaml.Text("name");
    yaml.Map("stereo", [&](YamlReader& sheet) { rig.stereo = ReadStereo(sheet); });
    yaml.Map("imu", [&](YamlReader& sheet) { rig.imu = ReadImu(sheet); });
    yaml.OptionalMap("sonar", [&](YamlReader& sheet) { rig.sonar = ReadSonar(sheet); });
    yaml.OptionalMap("depth", [&](YamlReader& sheet) { rig.depth = ReadDepth(sheet); });
    return rig;
  });
}

Rig LoadRig(const std::filesystem::path& path) { return ReadRig(LoadYaml(path)); }

std::vector<std::string> KnownRigs() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(RigFolder())) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::filesystem::path FindRig(const std::string& name_or_path) {
  if (name_or_path.ends_with(".yaml")) return name_or_path;
  const std::vector<std::string> known = KnownRigs();
  RequireInput(std::find(known.begin(), known.end(), name_or_path) != known.end(),
               "rig is {}, must be one of {}, or a path that ends in .yaml", name_or_path,
               fmt::join(known, ", "));
  return RigFolder() / (name_or_path + ".yaml");
}

}  // namespace drydock
