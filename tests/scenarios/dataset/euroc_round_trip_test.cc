#include <cstring>
#include <iterator>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/euroc_reader.h"
#include "scenarios/dataset/euroc_writer.h"
#include "sensors_models/base/check.h"
#include "tests/scenarios/dataset/euroc_support.h"
#include "tests/support/input_error.h"

namespace drydock::dataset {
namespace {

using drydock::testing::InputErrorOf;

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class EurocRoundTrip : public RecordingTest {};

void ExpectSame(const ImuSample& a, const ImuSample& b) {
  EXPECT_EQ(a.angular_rate, b.angular_rate);
  EXPECT_EQ(a.specific_force, b.specific_force);
}

void ExpectSame(const StereoFrame& a, const StereoFrame& b) {
  EXPECT_EQ(a.index, b.index);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(a.images[i].type(), b.images[i].type());
    ASSERT_EQ(a.images[i].size(), b.images[i].size());
    const std::size_t bytes = a.images[i].total() * a.images[i].elemSize();
    EXPECT_EQ(std::memcmp(a.images[i].data, b.images[i].data, bytes), 0);
  }
}

void ExpectSame(const SonarPing& a, const SonarPing& b) {
  EXPECT_EQ(a.head_angle, b.head_angle);
  EXPECT_EQ(a.range, b.range);
  EXPECT_EQ(a.intensity, b.intensity);
  EXPECT_EQ(a.first_range, b.first_range);
  EXPECT_EQ(a.profile, b.profile);
}

void ExpectSame(const DepthSample& a, const DepthSample& b) { EXPECT_EQ(a.depth, b.depth); }

void ExpectSame(const std::vector<Measurement>& dive, const EurocReader& reader) {
  ASSERT_EQ(reader.size(), dive.size());
  for (std::size_t i = 0; i < dive.size(); ++i) {
    const Measurement read = reader.Read(i);
    ASSERT_EQ(read.t, dive[i].t) << i;
    ASSERT_EQ(read.t_arrival, dive[i].t_arrival) << i;
    ASSERT_EQ(read.reading.index(), dive[i].reading.index()) << i;
    std::visit(
        [&](const auto& reading) {
          ExpectSame(reading, std::get<std::decay_t<decltype(reading)>>(dive[i].reading));
        },
        read.reading);
  }
}

TEST_F(EurocRoundTrip, MeasurementsComeBackInOrderToTheLastBit) {
  const std::vector<Measurement> dive = SmallDive();
  Record(dive);
  std::vector<std::string> warnings;
  const EurocReader reader(target(), [&](const std::string& w) { warnings.push_back(w); });
  EXPECT_THAT(warnings, ::testing::IsEmpty());
  ExpectSame(dive, reader);
  ExpectSame(dive, EurocReader(mav0()));
}

TEST_F(EurocRoundTrip, ColourImagesStayColour) {
  const std::vector<Measurement> dive = SmallDive(CV_8UC3);
  Record(dive);
  ExpectSame(dive, EurocReader(target()));
}

TEST_F(EurocRoundTrip, RigAndTruthComeBack) {
  Record(SmallDive());
  const EurocReader reader(target());
  EXPECT_EQ(reader.rig().name, "svin2_v3");
  EXPECT_EQ(reader.rig().stereo.T_IC[1].q().coeffs(), SmallRig().stereo.T_IC[1].q().coeffs());
  EXPECT_EQ(reader.rig().sonar.step_rad, SmallRig().sonar.step_rad);
  EXPECT_EQ(reader.rig().imu.gyro_range, SmallRig().imu.gyro_range);
  EXPECT_EQ(reader.rig().depth.resolution_m, SmallRig().depth.resolution_m);
  RandomStream random(2, "truth");
  const std::vector<StampedTruth> truth = reader.ReadTruth();
  ASSERT_EQ(truth.size(), 10U);
  for (const StampedTruth& row : truth) {
    const TruthState expected = RandomTruth(random);
    EXPECT_EQ(row.state.T_WI.p(), expected.T_WI.p());
    EXPECT_EQ(row.state.T_WI.q().coeffs(), expected.T_WI.q().coeffs());
    EXPECT_EQ(row.state.v_W, expected.v_W);
    EXPECT_EQ(row.state.gyro_bias, expected.gyro_bias);
    EXPECT_EQ(row.state.accel_bias, expected.accel_bias);
  }
  EXPECT_EQ(ToTrajectory(truth).size(), 10U);
}

TEST_F(EurocRoundTrip, SensorSheetsSayTheSameAsTheRig) {
  Record(SmallDive());
  fs::remove(mav0() / "rig.yaml");
  const Rig read = EurocReader(target()).rig(), rig = SmallRig();
  EXPECT_EQ(read.imu.gyro_scale_error, rig.imu.gyro_scale_error);
  EXPECT_EQ(read.imu.accel_scale_error, rig.imu.accel_scale_error);
  EXPECT_EQ(read.imu.gyro_misalignment, rig.imu.gyro_misalignment);
  EXPECT_EQ(read.imu.accel_misalignment, rig.imu.accel_misalignment);
  EXPECT_EQ(read.imu.gyro_range, rig.imu.gyro_range);
  EXPECT_EQ(read.imu.accel_range, rig.imu.accel_range);
  EXPECT_EQ(read.imu.gyro_resolution, rig.imu.gyro_resolution);
  EXPECT_EQ(read.imu.accel_resolution, rig.imu.accel_resolution);
  EXPECT_EQ(read.depth.offset_m, rig.depth.offset_m);
  EXPECT_EQ(read.depth.lag_s, rig.depth.lag_s);
  EXPECT_EQ(read.depth.resolution_m, rig.depth.resolution_m);
}

TEST_F(EurocRoundTrip, TheSameDiveGivesTheSameBytes) {
  Record(SmallDive());
  std::map<std::string, std::string> first;
  for (const auto& entry : fs::recursive_directory_iterator(target())) {
    if (entry.is_regular_file()) first[entry.path().string()] = ReadFile(entry.path());
  }
  Record(SmallDive());
  for (const auto& [path, bytes] : first) EXPECT_EQ(ReadFile(path), bytes) << path;
}

TEST_F(EurocRoundTrip, FilesAreAsEurocHasThem) {
  Record(SmallDive());
  EXPECT_THAT(ReadFile(mav0() / "imu0/data.csv"),
              ::testing::StartsWith(
                  "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
                  "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n1600000000000000000,"));
  EXPECT_THAT(ReadFile(mav0() / "cam1/data.csv"),
              ::testing::StartsWith(
                  "#timestamp [ns],filename\n1600000000000000000,1600000000000000000.png\n"));
  EXPECT_TRUE(fs::exists(mav0() / "cam0/data/1600000000000000000.png"));
  EXPECT_TRUE(fs::exists(mav0() / "body.yaml"));
  EXPECT_THAT(ReadFile(mav0() / "cam0/sensor.yaml"),
              AllOf(HasSubstr("sensor_type: camera\n"), HasSubstr("T_BS:\n  cols: 4\n  rows: 4\n"),
                    HasSubstr("resolution: [32, 24]\n"), HasSubstr("camera_model: pinhole\n"),
                    HasSubstr("distortion_model: radial-tangential\n")));
  // Two images, one of each camera, of which the sixth pair is missing.
  EXPECT_EQ(std::distance(fs::directory_iterator(mav0() / "cam0/data"), fs::directory_iterator()),
            9);
}

TEST_F(EurocRoundTrip, FisheyesComeBackFromOurRigAndFromTheSheets) {
  Rig rig = SmallRig();
  rig.stereo.cameras[1].lens = LensModel::kEquidistant;
  rig.stereo.cameras[1].distortion = {-0.01, 2.5, 0.02, -0.003};
  EurocWriter writer(rig, target());
  for (const Measurement& measurement : SmallDive()) writer.Add(measurement);
  writer.Commit();
  EXPECT_THAT(ReadFile(mav0() / "cam1/sensor.yaml"),
              HasSubstr("distortion_model: equidistant\n"
                        "distortion_coefficients: [-0.01, 2.5, 0.02, -0.003]  # k1, k2, k3, k4\n"));
  const auto expect_lenses = [&](const Rig& read) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read.stereo.cameras[i].lens, rig.stereo.cameras[i].lens);
      EXPECT_EQ(read.stereo.cameras[i].distortion, rig.stereo.cameras[i].distortion);
    }
  };
  expect_lenses(EurocReader(target()).rig());
  // The same numbers of another lens are another rig.
  Edit("rig.yaml", "equidistant", "radtan");
  Edit("rig.yaml", "2.5", "1.5");
  Edit("cam1/sensor.yaml", "2.5", "1.5");
  EXPECT_THROW(EurocReader{target()}, InputError);
  fs::remove(mav0() / "rig.yaml");
  Edit("cam1/sensor.yaml", "1.5", "2.5");
  expect_lenses(EurocReader(target()).rig());
}

TEST_F(EurocRoundTrip, TablesAreSortedByTimeWhateverTheArrival) {
  std::vector<Measurement> dive;
  for (const std::int64_t ns : {30, 10, 20}) {
    dive.push_back({Time{ns}, Time{100 + static_cast<std::int64_t>(dive.size())}, ImuSample{}});
  }
  Record(dive);
  EXPECT_THAT(ReadFile(mav0() / "imu0/data.csv"),
              HasSubstr("\n10,0,0,0,0,0,0\n20,0,0,0,0,0,0\n30,0,0,0,0,0,0\n"));
  ExpectSame(dive, EurocReader(target()));
}

TEST_F(EurocRoundTrip, SonarTruthAndDepthImages) {
  {
    EurocWriter writer(SmallRig(), target());
    writer.AddSonarTruth(Time{7}, 2.5, "hull, #port\nside");
    writer.AddSonarTruth(Time{5}, 0.0, "");
    cv::Mat depth(24, 32, CV_32FC1, cv::Scalar(1.2344F));
    depth.at<float>(0, 0) = std::numeric_limits<float>::infinity();
    depth.at<float>(0, 1) = std::numeric_limits<float>::quiet_NaN();
    depth.at<float>(0, 2) = -1.0F;
    depth.at<float>(0, 3) = 65.535F;
    depth.at<float>(0, 4) = 65.54F;
    writer.AddDepthImage(0, Time{5}, depth);
    writer.Commit();
  }
  EXPECT_EQ(ReadFile(mav0() / "sonar0_groundtruth/data.csv"),
            "#timestamp [ns],range [m],hit []\n5,0,-\n7,2.5,hull_ _port_side\n");
  const cv::Mat image =
      cv::imread((mav0() / "depth_image0/data/5.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.type(), CV_16UC1);
  EXPECT_EQ(image.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(image.at<std::uint16_t>(0, 1), 0);
  EXPECT_EQ(image.at<std::uint16_t>(0, 2), 0);
  EXPECT_EQ(image.at<std::uint16_t>(0, 3), 65535);
  EXPECT_EQ(image.at<std::uint16_t>(0, 4), 0);
  EXPECT_EQ(image.at<std::uint16_t>(10, 10), 1234);
  EXPECT_FALSE(fs::exists(mav0() / "depth_image1"));
  EXPECT_NO_THROW(EurocReader{target()});
}

TEST_F(EurocRoundTrip, ProfilesAreKeptOnlyWhereThereAreAny) {
  const SonarPing bare{1.0, 2.0, 0.5, 1.5, {}};
  Record({{Time{5}, Time{5}, bare}});
  EXPECT_FALSE(fs::exists(mav0() / "sonar0_profile"));
  SonarPing full = bare;
  full.profile.assign(255, 0);
  full.profile[0] = 7;
  full.profile[254] = 255;
  Record({{Time{5}, Time{5}, bare}, {Time{6}, Time{6}, full}});
  EXPECT_THAT(ReadFile(mav0() / "sonar0_profile/data.csv"),
              AllOf(HasSubstr("\n6,7,0,0,"), HasSubstr(",0,255\n")));
}

// Recordings of others, and ours of old, do not know the nearest echo.
TEST_F(EurocRoundTrip, WithoutFirstRangeTheStrongestEchoIsTheFirst) {
  Record({{Time{5}, Time{5}, SonarPing{1.0, 2.0, 0.5, 1.5, {}}}});
  WriteFileAtomically(mav0() / "sonar0/data.csv", "5,2.0,1.0,0.5\n");
  const EurocReader reader(target());
  EXPECT_EQ(std::get<SonarPing>(reader.Read(0).reading).first_range, 2.0);
}

TEST_F(EurocRoundTrip, WithoutCommitThereIsNothing) {
  {
    EurocWriter writer(SmallRig(), target());
    for (const Measurement& measurement : SmallDive()) writer.Add(measurement);
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(EurocRoundTrip, WriterRefusesWhatCannotBe) {
  EurocWriter writer(SmallRig(), target());
  EXPECT_THROW(writer.Add({Time{-1}, Time{0}, ImuSample{}}), std::logic_error);
  EXPECT_THROW(writer.Add({Time{5}, Time{4}, ImuSample{}}), std::logic_error);
  StereoFrame wrong_size;
  wrong_size.images = {cv::Mat(10, 10, CV_8UC1, cv::Scalar(0)),
                       cv::Mat(10, 10, CV_8UC1, cv::Scalar(0))};
  EXPECT_THROW(writer.Add({Time{5}, Time{5}, wrong_size}), std::logic_error);
  SonarPing short_profile;
  short_profile.profile = {1, 2, 3};
  EXPECT_THROW(writer.Add({Time{5}, Time{5}, short_profile}), std::logic_error);
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(EurocRoundTrip, WriterRefusesASecondRowOfTheSameTimeAndKeepsTheFirst) {
  EurocWriter writer(SmallRig(), target());
  writer.Add({Time{6}, Time{6}, DepthSample{1.0}});
  writer.Add({Time{6}, Time{6}, SonarPing{}});  // Another sensor may.
  const std::string error = InputErrorOf([&] { writer.Add({Time{6}, Time{7}, DepthSample{2.0}}); });
  EXPECT_EQ(error, "pressure0: a second row at 6 ns, must have one a time");
  writer.AddTruth(Time{6}, {});
  EXPECT_THROW(writer.AddTruth(Time{6}, {}), InputError);
  writer.Commit();
  EXPECT_EQ(ReadFile(mav0() / "pressure0/data.csv"), "#timestamp [ns],depth [m]\n6,1\n");
  EXPECT_EQ(ReadFile(mav0() / "arrivals.csv"),
            "#timestamp [ns],arrival [ns],sensor,index []\n6,6,pressure0,0\n6,6,sonar0,0\n");
}

}  // namespace
}  // namespace drydock::dataset
