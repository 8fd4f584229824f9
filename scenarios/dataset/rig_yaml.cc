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
  fmt::format_to(to, "      radtan: [{}, {}, {}, {}]\n", k[0], k[1], k[2], k[3]);
  return out;
}

std::string FormatStereo(const StereoSheet& stereo) {
  std::string out = fmt::format("stereo:\n  rate_hz: {}\n  cameras:\n", stereo.rate_hz);
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
  return fmt::format("depth:\n  rate_hz: {}\n  position_m: {}\n  noise_m: {}\n", depth.rate_hz,
                     List(depth.p_ID), depth.noise_m);
}

}  // namespace

std::string FormatRig(const Rig& rig) {
  std::string out = Quote(rig.name) + FormatStereo(rig.stereo) + FormatImu(rig.imu);
  if (rig.HasSonar()) out += FormatSonar(rig.sonar);
  if (rig.HasDepth()) out += FormatDepth(rig.depth);
  return out;
}

}  // namespace drydock::dataset
