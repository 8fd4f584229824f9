// The names inside a recording: EuRoC's, and those we add where EuRoC has none.
//
//   mav0/body.yaml
//   mav0/cam0/, cam1/         sensor.yaml, data.csv, data/<ns>.png
//   mav0/imu0/                sensor.yaml, data.csv
//   mav0/state_groundtruth_estimate0/   sensor.yaml, data.csv (17 columns, quaternion w first)
// ours:
//   mav0/sonar0/              sensor.yaml, data.csv: what the profiling sonar said
//   mav0/pressure0/           sensor.yaml, data.csv: depth by pressure (other tools take the name
//                             depth0 for depth images)
//   mav0/sonar0_profile/      data.csv: the echo of each ping by range bin, where it was kept
//   mav0/sonar0_groundtruth/  data.csv: true range of each ping and what it hit
//   mav0/depth_image0/, 1/    data.csv, data/<ns>.png: 16-bit millimetres along the camera's z
//   axis,
//                             0 where there is nothing within 65.535 m
//   mav0/arrivals.csv         every measurement in the order in which the robot had it
//   mav0/rig.yaml             the rig to the last bit, as ReadRig reads it
#pragma once

#include <array>

namespace drydock::dataset {

inline constexpr const char* kRoot = "mav0";
inline constexpr const char* kBodyFile = "body.yaml";
inline constexpr const char* kRigFile = "rig.yaml";
inline constexpr const char* kArrivalsFile = "arrivals.csv";
inline constexpr const char* kSensorFile = "sensor.yaml";
inline constexpr const char* kDataFile = "data.csv";
inline constexpr const char* kDataFolder = "data";

inline constexpr std::array<const char*, 2> kCameraFolders = {"cam0", "cam1"};
inline constexpr std::array<const char*, 2> kDepthImageFolders = {"depth_image0", "depth_image1"};
inline constexpr const char* kImuFolder = "imu0";
inline constexpr const char* kSonarFolder = "sonar0";
inline constexpr const char* kSonarProfileFolder = "sonar0_profile";
inline constexpr const char* kSonarTruthFolder = "sonar0_groundtruth";
inline constexpr const char* kPressureFolder = "pressure0";
inline constexpr const char* kTruthFolder = "state_groundtruth_estimate0";

inline constexpr const char* kCameraHeader = "#timestamp [ns],filename";
inline constexpr const char* kImuHeader =
    "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
    "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]";
inline constexpr const char* kSonarHeader =
    "#timestamp [ns],range [m],head_position [rad],intensity [],first_range [m]";
inline constexpr const char* kSonarProfileHeader =
    "#timestamp [ns],amplitude in each bin from the head outwards [0 to 255]";
inline constexpr const char* kSonarTruthHeader = "#timestamp [ns],range [m],hit []";
inline constexpr const char* kPressureHeader = "#timestamp [ns],depth [m]";
inline constexpr const char* kTruthHeader =
    "#timestamp,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],"
    "q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],"
    "v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1],"
    "b_w_RS_S_x [rad s^-1],b_w_RS_S_y [rad s^-1],b_w_RS_S_z [rad s^-1],"
    "b_a_RS_S_x [m s^-2],b_a_RS_S_y [m s^-2],b_a_RS_S_z [m s^-2]";
/// `index` is the frame's number (StereoFrame::index) for cam0, which stands for both cameras, and
/// the sample's number for all others.
inline constexpr const char* kArrivalsHeader = "#timestamp [ns],arrival [ns],sensor,index []";

}  // namespace drydock::dataset
