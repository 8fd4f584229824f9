#include "sensors_models/measurement/rig.h"

#include <cmath>
#include <numbers>

#include "sensors_models/base/check.h"
#include "sensors_models/base/resources.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock {
namespace {

constexpr Bounds kRate{0.01, 10'000.0};
constexpr Bounds kOffset{-10.0, 10.0};
constexpr Bounds kNoise{0.0, 1e3};

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

CameraIntrinsics ReadIntrinsics(YamlReader& yaml) {
  CameraIntrinsics camera;
  camera.width = static_cast<int>(yaml.Integer("width_px", {16, 8192}));
  camera.height = static_cast<int>(yaml.Integer("height_px", {16, 8192}));
  const auto focal = yaml.Reals("focal_px", {1.0, 1e5}, 2);
  const auto centre = yaml.Reals("principal_point_px", {0.0, 8192.0}, 2);
  const auto radtan = yaml.Reals("radtan", {-2.0, 2.0}, 4);
  camera.fx = focal[0];
  camera.fy = focal[1];
  camera.cx = centre[0];
  camera.cy = centre[1];
  std::copy(radtan.begin(), radtan.end(), camera.distortion.begin());
  return camera;
}

StereoSheet ReadStereo(YamlReader& yaml) {
  StereoSheet stereo;
  stereo.rate_hz = yaml.Real("rate_hz", kRate);
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
  return depth;
}

}  // namespace

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

std::filesystem::path FindRig(const std::string& name_or_path) {
  if (name_or_path.ends_with(".yaml")) return name_or_path;
  const auto folder = DataDirectory() / "sensors_models" / "measurement" / "rigs";
  const auto path = folder / (name_or_path + ".yaml");
  RequireInput(std::filesystem::exists(path), "rig '{}': no such file {}", name_or_path,
               path.string());
  return path;
}

}  // namespace drydock
