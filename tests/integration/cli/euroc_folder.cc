#include "tests/integration/cli/euroc_folder.h"

#include <string>
#include <variant>

#include <fmt/format.h>

#include "scenarios/dataset/euroc_reader.h"
#include "sensors_models/base/files.h"

namespace drydock::testing {
namespace {

namespace fs = std::filesystem;

/// Turns our body (x forward, y left, z up) into theirs.
Pose TheirBody() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  return {Eigen::Quaterniond(R), Eigen::Vector3d::Zero()};
}

std::string Mounting(const Pose& T_BS) {
  const Eigen::Matrix3d R = T_BS.R();
  std::string out =
      "# Sensor extrinsics wrt. the body-frame.\nT_BS:\n  cols: 4\n  rows: 4\n  data: [";
  for (int row = 0; row < 3; ++row) {
    out += fmt::format("{:.13f}, {:.13f}, {:.13f}, {:.13f},\n         ", R(row, 0), R(row, 1),
                       R(row, 2), T_BS.p()(row));
  }
  return out + "0.0, 0.0, 0.0, 1.0]\n";
}

std::string CameraSheet(int camera, const StereoSheet& stereo) {
  const CameraIntrinsics& c = stereo.cameras.at(static_cast<std::size_t>(camera));
  const auto& k = c.distortion;
  return fmt::format(
      "# General sensor definitions.\nsensor_type: camera\ncomment: VI-Sensor cam{} (MT9M034)\n\n"
      "{}\n# Camera specific definitions.\nrate_hz: {}\nresolution: [{}, {}]\n"
      "camera_model: pinhole\nintrinsics: [{}, {}, {}, {}] #fu, fv, cu, cv\n"
      "distortion_model: {}\ndistortion_coefficients: [{}, {}, {}, {}]\n\n",
      camera, Mounting(TheirBody() * stereo.T_IC.at(static_cast<std::size_t>(camera))),
      stereo.rate_hz, c.width, c.height, c.fx, c.fy, c.cx, c.cy,
      c.lens == LensModel::kRadtan ? "radial-tangential" : "equidistant", k[0], k[1], k[2], k[3]);
}

std::string ImuSheetText(const ImuSheet& imu) {
  return fmt::format(
      "#Default imu sensor yaml file\nsensor_type: imu\ncomment: VI-Sensor IMU (ADIS16448)\n\n"
      "{}rate_hz: {:.0f}\n\n# inertial sensor noise model parameters (static)\n"
      "gyroscope_noise_density: {}     # [ rad / s / sqrt(Hz) ]   ( gyro \"white noise\" )\n"
      "gyroscope_random_walk: {}       # [ rad / s^2 / sqrt(Hz) ] ( gyro bias diffusion )\n"
      "accelerometer_noise_density: {}  # [ m / s^2 / sqrt(Hz) ]   ( accel \"white noise\" )\n"
      "accelerometer_random_walk: {}    # [ m / s^3 / sqrt(Hz) ].  ( accel bias diffusion )\n",
      Mounting(Pose()), imu.rate_hz, imu.gyro_noise_density, imu.gyro_bias_walk,
      imu.accel_noise_density, imu.accel_bias_walk);
}

/// Nothing of these is read; all of it must be borne.
void AddWhatTheyHaveBesides(const fs::path& mav0) {
  WriteFileAtomically(mav0 / "body.yaml", "%YAML:1.0\ncomment: VI-Sensor, Vicon marker, prism\n");
  for (const char* folder : {"leica0", "vicon0", "pointcloud0"})
    fs::create_directories(mav0 / folder);
  WriteFileAtomically(mav0 / "leica0" / "sensor.yaml",
                      "sensor_type: position\ncomment: Leica Nova MS53\n" + Mounting(Pose()));
  WriteFileAtomically(
      mav0 / "leica0" / "data.csv",
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m]\r\n7,1.0,2.0,3.0\r\n");
  WriteFileAtomically(mav0 / "vicon0" / "sensor.yaml",
                      "sensor_type: pose\ncomment: Vicon\n" + Mounting(Pose()));
  WriteFileAtomically(mav0 / "vicon0" / "data.csv", "#timestamp [ns],p_RS_R_x [m]\r\n7,1.0\r\n");
  WriteFileAtomically(mav0 / "pointcloud0" / "sensor.yaml", "sensor_type: pointcloud\n");
  WriteFileAtomically(mav0 / "pointcloud0" / "data.ply", "ply\nformat ascii 1.0\n");
}

std::string ImuTable(const dataset::EurocReader& reader) {
  const Pose theirs = TheirBody();
  std::string table =
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
      "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\r\n";
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const Measurement measurement = reader.Read(i);
    const auto* imu = std::get_if<ImuSample>(&measurement.reading);
    if (imu == nullptr) continue;
    const Eigen::Vector3d w = theirs.q() * imu->angular_rate;
    const Eigen::Vector3d a = theirs.q() * imu->specific_force;
    table += fmt::format("{},{},{},{},{},{},{}\r\n", measurement.t.ns, w.x(), w.y(), w.z(), a.x(),
                         a.y(), a.z());
  }
  return table;
}

std::string TruthTable(const dataset::EurocReader& reader) {
  std::string table =
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
      "q_RS_z []\r\n";
  for (const dataset::StampedTruth& row : reader.ReadTruth()) {
    const Pose T = row.state.T_WI * TheirBody().Inverse();
    table +=
        fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\r\n", row.t.ns, T.p().x(),
                    T.p().y(), T.p().z(), T.q().w(), T.q().x(), T.q().y(), T.q().z());
  }
  return table;
}

void EndLinesAsWindowsDoes(const fs::path& file) {
  std::string text;
  for (const char c : ReadFile(file)) {
    if (c == '\n') text += '\r';
    text += c;
  }
  WriteFileAtomically(file, text);
}

}  // namespace

void MakeLikeEuroc(const fs::path& target) {
  const fs::path mav0 = target / "mav0";
  const dataset::EurocReader reader(target);
  const Rig& rig = reader.rig();
  const fs::path truth = mav0 / "state_groundtruth_estimate0";
  WriteFileAtomically(truth / "data.csv", TruthTable(reader));
  WriteFileAtomically(truth / "sensor.yaml",
                      "sensor_type: visual-inertial\ncomment: ground truth\n" + Mounting(Pose()));
  WriteFileAtomically(mav0 / "imu0" / "data.csv", ImuTable(reader));
  WriteFileAtomically(mav0 / "imu0" / "sensor.yaml", ImuSheetText(rig.imu));
  for (const int camera : {0, 1}) {
    const fs::path folder = mav0 / fmt::format("cam{}", camera);
    WriteFileAtomically(folder / "sensor.yaml", CameraSheet(camera, rig.stereo));
    EndLinesAsWindowsDoes(folder / "data.csv");
  }
  for (const char* ours : {"rig.yaml", "arrivals.csv", "sonar0", "sonar0_profile",
                           "sonar0_groundtruth", "pressure0", "depth_image0", "depth_image1"})
    fs::remove_all(mav0 / ours);
  AddWhatTheyHaveBesides(mav0);
}

}  // namespace drydock::testing
