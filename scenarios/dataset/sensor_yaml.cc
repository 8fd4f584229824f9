#include "scenarios/dataset/sensor_yaml.h"

#include <iterator>

#include <fmt/format.h>

namespace drydock::dataset {
namespace {

/// The lines that every sensor.yaml begins with; T_BS takes points of the sensor into the body.
std::string FormatHead(std::string_view type, std::string_view comment, const Pose& T_BS) {
  const Eigen::Matrix3d R = T_BS.R();
  std::string out = fmt::format(
      "sensor_type: {}\ncomment: {}\nT_BS:\n  cols: 4\n  rows: 4\n  data: [", type, comment);
  for (int row = 0; row < 3; ++row) {
    fmt::format_to(std::back_inserter(out), "{}, {}, {}, {},\n         ", R(row, 0), R(row, 1),
                   R(row, 2), T_BS.p()(row));
  }
  return out + "0.0, 0.0, 0.0, 1.0]\n";
}

std::string FormatOptics(const CameraIntrinsics& camera, double rate_hz) {
  const auto& k = camera.distortion;
  std::string out;
  auto to = std::back_inserter(out);
  fmt::format_to(to, "rate_hz: {}\nresolution: [{}, {}]\n", rate_hz, camera.width, camera.height);
  fmt::format_to(to, "camera_model: pinhole\nintrinsics: [{}, {}, {}, {}]  # fu, fv, cu, cv [px]\n",
                 camera.fx, camera.fy, camera.cx, camera.cy);
  fmt::format_to(to, "distortion_model: {}\ndistortion_coefficients: [{}, {}, {}, {}]  # {}\n",
                 DistortionModel(camera.lens), k[0], k[1], k[2], k[3],
                 camera.lens == LensModel::kRadtan ? "k1, k2, p1, p2" : "k1, k2, k3, k4");
  return out;
}

}  // namespace

std::string DistortionModel(LensModel lens) {
  return lens == LensModel::kRadtan ? "radial-tangential" : "equidistant";
}

std::string FormatBodyYaml(const Rig& rig) {
  return fmt::format(
      "# The body frame is the IMU: x forward, y left, z up. The rig is '{}'.\n"
      "comment: recorded by Drydock\n",
      rig.name);
}

std::string FormatCameraYaml(const Rig& rig, std::size_t camera) {
  const std::string_view side = camera == 0 ? "left camera" : "right camera";
  return FormatHead("camera", side, rig.stereo.T_IC.at(camera)) +
         FormatOptics(rig.stereo.cameras.at(camera), rig.stereo.rate_hz);
}

std::string FormatImuYaml(const Rig& rig) {
  const ImuSheet& imu = rig.imu;
  std::string out = FormatHead("imu", "inertial measurement unit, the body frame", Pose());
  auto to = std::back_inserter(out);
  fmt::format_to(to, "rate_hz: {}\n", imu.rate_hz);
  fmt::format_to(to, "gyroscope_noise_density: {}  # [rad/s/sqrt(Hz)]\n", imu.gyro_noise_density);
  fmt::format_to(to, "gyroscope_random_walk: {}  # [rad/s^2/sqrt(Hz)]\n", imu.gyro_bias_walk);
  fmt::format_to(to, "accelerometer_noise_density: {}  # [m/s^2/sqrt(Hz)]\n",
                 imu.accel_noise_density);
  fmt::format_to(to, "accelerometer_random_walk: {}  # [m/s^3/sqrt(Hz)]\n", imu.accel_bias_walk);
  fmt::format_to(to, "gyroscope_turn_on_bias: {}  # standard deviation [rad/s]\n",
                 imu.gyro_turn_on_bias);
  fmt::format_to(to, "accelerometer_turn_on_bias: {}  # standard deviation [m/s^2]\n",
                 imu.accel_turn_on_bias);
  fmt::format_to(to, "gyroscope_scale_error: {}  # standard deviation\n", imu.gyro_scale_error);
  fmt::format_to(to, "accelerometer_scale_error: {}  # standard deviation\n",
                 imu.accel_scale_error);
  fmt::format_to(to, "gyroscope_misalignment: {}  # standard deviation [rad]\n",
                 imu.gyro_misalignment);
  fmt::format_to(to, "accelerometer_misalignment: {}  # standard deviation [rad]\n",
                 imu.accel_misalignment);
  fmt::format_to(to, "gyroscope_range: {}  # [rad/s], 0 is no limit\n", imu.gyro_range);
  fmt::format_to(to, "accelerometer_range: {}  # [m/s^2], 0 is no limit\n", imu.accel_range);
  fmt::format_to(to, "gyroscope_resolution: {}  # [rad/s]\n", imu.gyro_resolution);
  fmt::format_to(to, "accelerometer_resolution: {}  # [m/s^2]\n", imu.accel_resolution);
  return out;
}

std::string FormatSonarYaml(const Rig& rig) {
  const SonarSheet& sonar = rig.sonar;
  std::string out = FormatHead(
      "profiling_sonar",
      "one beam along (cos h, sin h, 0) of its own frame at head position h; range 0 is no echo",
      sonar.T_IS);
  auto to = std::back_inserter(out);
  fmt::format_to(to, "rate_hz: {}\n", sonar.rate_hz);
  fmt::format_to(to, "min_range: {}  # [m]\nmax_range: {}  # [m]\n", sonar.min_range_m,
                 sonar.max_range_m);
  fmt::format_to(to, "range_resolution: {}  # standard deviation of a range [m]\n",
                 sonar.range_noise_m);
  fmt::format_to(to, "head_step: {}  # from ping to ping [rad]\n", sonar.step_rad);
  fmt::format_to(to, "beam_width: {}  # full, where one way is 3 dB down [rad]\n",
                 sonar.beam_width_rad);
  fmt::format_to(to, "bins: {}  # up to max_range; 0 is no echo profile\n", sonar.bins);
  fmt::format_to(to, "intensity_floor: {}  # weaker echoes do not count\n", sonar.intensity_floor);
  return out;
}

std::string FormatPressureYaml(const Rig& rig) {
  const DepthSheet& depth = rig.depth;
  std::string out = FormatHead("pressure", "depth below the surface, positive downwards",
                               Pose(Eigen::Quaterniond::Identity(), depth.p_ID));
  auto to = std::back_inserter(out);
  fmt::format_to(to, "rate_hz: {}\n", depth.rate_hz);
  fmt::format_to(to, "depth_noise: {}  # standard deviation [m]\n", depth.noise_m);
  fmt::format_to(to, "depth_offset: {}  # standard deviation of a constant [m]\n", depth.offset_m);
  fmt::format_to(to, "depth_lag: {}  # time constant [s]\n", depth.lag_s);
  fmt::format_to(to, "depth_resolution: {}  # [m]\n", depth.resolution_m);
  return out;
}

std::string FormatTruthYaml() {
  return FormatHead("visual-inertial", "exact state from the simulator", Pose());
}

std::string FormatDepthImageYaml(const Rig& rig, std::size_t camera) {
  return FormatHead("depth_image", "16-bit millimetres along z of the camera, 0 is nothing",
                    rig.stereo.T_IC.at(camera)) +
         FormatOptics(rig.stereo.cameras.at(camera), rig.stereo.rate_hz);
}

}  // namespace drydock::dataset
