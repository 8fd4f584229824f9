#include "scenarios/dataset/rig_yaml.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "sensors_models/base/yaml_node.h"

namespace drydock::dataset {
namespace {

std::string Quote(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::kMap;
  YamlNode value;
  value.kind = YamlNode::Kind::kScalar;
  value.text = text;
  value.quoted = true;
  node.members.emplace_back("name", std::move(value));
  return EmitYaml(node);
}

/// Degrees that come back as the same radians, where such degrees exist.
double ToDegrees(double radians) {
  const double nearest = radians * 180.0 / std::numbers::pi;
  for (const double toward : {nearest, -std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()}) {
    double degrees = nearest;
    for (int step = 0; step < 4; ++step) {
      if (degrees * std::numbers::pi / 180.0 == radians) return degrees;
      degrees = std::nextafter(degrees, toward);
    }
  }
  return nearest;
}

std::string List(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string List(const Eigen::Quaterniond& q) {
  return fmt::format("[{}, {}, {}, {}]", q.x(), q.y(), q.z(), q.w());
}

std::string FormatCamera(const CameraIntrinsics& camera, const Pose& T_IC) {
  const auto& k = camera.distortion;
  std::string out;
  auto to = std::back_inserter(out);
  fmt::format_to(to, "    - position_m: {}\n", List(T_IC.p()));
  fmt::format_to(to, "      quaternion_xyzw: {}\n", List(T_IC.q()));
  fmt::format_to(to, "      width_px: {}\n      height_px: {}\n", camera.width, camera.height);
  fmt::format_to(to, "      focal_px: [{}, {}]\n", camera.fx, camera.fy);
  fmt::format_to(to, "      principal_point_px: [{}, {}]\n", camera.cx, camera.cy);
  fmt::format_to(to, "      {}: [{}, {}, {}, {}]\n", LensKey(camera.lens), k[0], k[1], k[2], k[3]);
  return out;
}

std::string FormatImager(const ImagerSheet& imager) {
  std::string out = "  imager:\n";
  auto to = std::back_inserter(out);
  fmt::format_to(to, "    gamma: {}\n", imager.gamma);
  fmt::format_to(to, "    sensitivity_per_s: {}\n", imager.sensitivity_per_s);
  fmt::format_to(to, "    shutter_max_s: {}\n", imager.shutter_max_s);
  fmt::format_to(to, "    gain_max_db: {}\n", imager.gain_max_db);
  fmt::format_to(to, "    auto_exposure_target: {}\n", imager.auto_exposure_target);
  fmt::format_to(to, "    auto_exposure_time_s: {}\n", imager.auto_exposure_time_s);
  fmt::format_to(to, "    full_well_e: {}\n", imager.full_well_e);
  fmt::format_to(to, "    read_noise_e: {}\n", imager.read_noise_e);
  fmt::format_to(to, "    vignetting: {}\n", imager.vignetting);
  return out;
}

std::string FormatStereo(const StereoSheet& stereo) {
  std::string out = fmt::format("stereo:\n  rate_hz: {}\n", stereo.rate_hz);
  out += FormatImager(stereo.imager) + "  cameras:\n";
  for (std::size_t i = 0; i < 2; ++i) out += FormatCamera(stereo.cameras[i], stereo.T_IC[i]);
  return out;
}

std::string FormatImu(const ImuSheet& imu) {
  std::string out = "imu:\n";
  auto to = std::back_inserter(out);
  fmt::format_to(to, "  rate_hz: {}\n", imu.rate_hz);
  fmt::format_to(to, "  gyro_noise_density_rad_s_sqrthz: {}\n", imu.gyro_noise_density);
  fmt::format_to(to, "  accel_noise_density_m_s2_sqrthz: {}\n", imu.accel_noise_density);
  fmt::format_to(to, "  gyro_bias_walk_rad_s2_sqrthz: {}\n", imu.gyro_bias_walk);
  fmt::format_to(to, "  accel_bias_walk_m_s3_sqrthz: {}\n", imu.accel_bias_walk);
  fmt::format_to(to, "  gyro_turn_on_bias_rad_s: {}\n", imu.gyro_turn_on_bias);
  fmt::format_to(to, "  accel_turn_on_bias_m_s2: {}\n", imu.accel_turn_on_bias);
  fmt::format_to(to, "  gyro_scale_error: {}\n", imu.gyro_scale_error);
  fmt::format_to(to, "  accel_scale_error: {}\n", imu.accel_scale_error);
  fmt::format_to(to, "  gyro_misalignment_rad: {}\n", imu.gyro_misalignment);
  fmt::format_to(to, "  accel_misalignment_rad: {}\n", imu.accel_misalignment);
  fmt::format_to(to, "  gyro_range_rad_s: {}\n", imu.gyro_range);
  fmt::format_to(to, "  accel_range_m_s2: {}\n", imu.accel_range);
  fmt::format_to(to, "  gyro_resolution_rad_s: {}\n", imu.gyro_resolution);
  fmt::format_to(to, "  accel_resolution_m_s2: {}\n", imu.accel_resolution);
  return out;
}

std::string FormatEcho(const SonarSheet& sonar) {
  std::string out;
  auto to = std::back_inserter(out);
  fmt::format_to(to, "  beam_width_deg: {}\n", ToDegrees(sonar.beam_width_rad));
  fmt::format_to(to, "  bins: {}\n", sonar.bins);
  fmt::format_to(to, "  pulse_length_s: {}\n", sonar.pulse_length_s);
  fmt::format_to(to, "  incidence_exponent: {}\n", sonar.incidence_exponent);
  fmt::format_to(to, "  absorption_db_m: {}\n", sonar.absorption_db_m);
  fmt::format_to(to, "  gain_absorption_db_m: {}\n", sonar.gain_absorption_db_m);
  fmt::format_to(to, "  speckle_looks: {}\n", sonar.speckle_looks);
  fmt::format_to(to, "  noise_floor: {}\n", sonar.noise_floor);
  fmt::format_to(to, "  dropout_probability: {}\n", sonar.dropout_probability);
  fmt::format_to(to, "  intensity_floor: {}\n", sonar.intensity_floor);
  return out;
}

std::string FormatSonar(const SonarSheet& sonar) {
  std::string out = "sonar:\n";
  auto to = std::back_inserter(out);
  fmt::format_to(to, "  rate_hz: {}\n", sonar.rate_hz);
  fmt::format_to(to, "  position_m: {}\n", List(sonar.T_IS.p()));
  fmt::format_to(to, "  quaternion_xyzw: {}\n", List(sonar.T_IS.q()));
  fmt::format_to(to, "  step_deg: {}\n", ToDegrees(sonar.step_rad));
  fmt::format_to(to, "  min_range_m: {}\n", sonar.min_range_m);
  fmt::format_to(to, "  max_range_m: {}\n", sonar.max_range_m);
  fmt::format_to(to, "  range_noise_m: {}\n", sonar.range_noise_m);
  return out + FormatEcho(sonar);
}

std::string FormatDepth(const DepthSheet& depth) {
  std::string out = "depth:\n";
  auto to = std::back_inserter(out);
  fmt::format_to(to, "  rate_hz: {}\n", depth.rate_hz);
  fmt::format_to(to, "  position_m: {}\n", List(depth.p_ID));
  fmt::format_to(to, "  noise_m: {}\n", depth.noise_m);
  fmt::format_to(to, "  offset_m: {}\n", depth.offset_m);
  fmt::format_to(to, "  lag_s: {}\n", depth.lag_s);
  fmt::format_to(to, "  resolution_m: {}\n", depth.resolution_m);
  return out;
}

}  // namespace

std::string FormatRig(const Rig& rig) {
  std::string out = Quote(rig.name) + FormatStereo(rig.stereo) + FormatImu(rig.imu);
  if (rig.HasSonar()) out += FormatSonar(rig.sonar);
  if (rig.HasDepth()) out += FormatDepth(rig.depth);
  return out;
}

}  // namespace drydock::dataset
