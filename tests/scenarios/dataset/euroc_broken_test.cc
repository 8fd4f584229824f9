// Recordings in which something is wrong: each is an InputError that says where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "scenarios/dataset/euroc_reader.h"
#include "sensors_models/base/check.h"
#include "tests/scenarios/dataset/euroc_support.h"
#include "tests/support/input_error.h"

namespace drydock::dataset {
namespace {

using drydock::testing::InputErrorOf;

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Everything in the recording, images and truth too; the error's message or "".
std::string ReadAll(const fs::path& target) {
  return InputErrorOf([&] {
    const EurocReader reader(target);
    for (std::size_t i = 0; i < reader.size(); ++i) reader.Read(i);
    reader.ReadTruth();
  });
}

struct Break {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
  const char* place;
  const char* says;
};

class EurocBroken : public RecordingTest, public ::testing::WithParamInterface<Break> {};

TEST_P(EurocBroken, IsNamedWithFileAndLine) {
  Record(SmallDive());
  Edit(GetParam().file, GetParam().from, GetParam().to);
  const std::string message = ReadAll(target());
  EXPECT_THAT(message, AllOf(HasSubstr(GetParam().place), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Edits, EurocBroken,
    ::testing::Values(
        Break{"ImuColumns", "imu0/data.csv", "\n1600000000050000000,", "\n1600000000050000000,1,",
              "imu0/data.csv:3", "8 fields"},
        Break{"ImuNan", "imu0/data.csv", "\n1600000000050000000,", "\n1600000000050000000,nan,",
              "imu0/data.csv:3", "8 fields"},
        Break{"ImuSeconds", "imu0/data.csv", "\n1600000000050000000,", "\n1600000000.05,",
              "imu0/data.csv:3", "nanoseconds"},
        Break{"ImuOrder", "imu0/data.csv", "\n1600000000050000000,", "\n1600000000000000000,",
              "imu0/data.csv:3", "later than"},
        Break{"ImuType", "imu0/sensor.yaml", "sensor_type: imu", "sensor_type: camera",
              "imu0/sensor.yaml:1", "must be one of imu"},
        Break{"ImuNoise", "imu0/sensor.yaml", "gyroscope_noise_density: ",
              "gyroscope_noise_density: -", "imu0/sensor.yaml:11", "from 0 to"},
        Break{"ImuKeyMissing", "imu0/sensor.yaml", "accelerometer_random_walk", "walk",
              "imu0/sensor.yaml", "'accelerometer_random_walk' is missing"},
        Break{"NotYaml", "imu0/sensor.yaml", "rate_hz: ", "rate_hz: [", "imu0/sensor.yaml", ""},
        Break{"CameraMatrix", "cam0/sensor.yaml", "0.0, 0.0, 0.0, 1.0]", "0.0, 0.0, 0.0, 2.0]",
              "cam0/sensor.yaml:6", "a rotation"},
        Break{"CameraMatrixSize", "cam0/sensor.yaml", ", 0.0, 0.0, 1.0]", ", 0.0, 1.0]",
              "cam0/sensor.yaml:6", "16 numbers"},
        Break{"CameraModel", "cam1/sensor.yaml", "pinhole", "omni", "cam1/sensor.yaml", "omni"},
        Break{"CameraSizes", "cam1/sensor.yaml", "[32, 24]", "[64, 24]", "cam1/sensor.yaml",
              "that of cam0"},
        Break{"CameraRates", "cam1/sensor.yaml", "rate_hz: 15", "rate_hz: 10", "cam1/sensor.yaml",
              "that of cam0"},
        Break{"CameraNameFolder", "cam0/data.csv", ",1600000000200000000.png",
              ",../1600000000200000000.png", "cam0/data.csv:3", "without a folder"},
        Break{"CameraImageMissing", "cam0/data.csv", ",1600000000200000000.png", ",other.png",
              "cam0/data/other.png", "no such file"},
        Break{"SonarRange", "sonar0/data.csv", "\n1600000000100000000,", "\n1600000000100000000,-",
              "sonar0/data.csv:3", "at least 0"},
        Break{"SonarFirstRange", "sonar0/data.csv", ",0.5,0\n", ",0.5,-1\n", "sonar0/data.csv:2",
              "at least 0"},
        Break{"SonarBins", "sonar0/sensor.yaml", "bins: 255", "bins: 254", "rig.yaml", "sonar0"},
        Break{"ProfileColumns", "sonar0_profile/data.csv", "\n1600000000100000000,",
              "\n1600000000100000000,1,", "sonar0_profile/data.csv:2", "257 fields"},
        Break{"ProfileLevel", "sonar0_profile/data.csv", "\n1600000000100000000,",
              "\n1600000000100000000,999", "sonar0_profile/data.csv:2", "from 0 to 255"},
        Break{"ProfileTime", "sonar0_profile/data.csv", "\n1600000000100000000,",
              "\n1600000000100000001,", "sonar0_profile/data.csv:2", "time of a ping"},
        Break{"SonarMaxRange", "sonar0/sensor.yaml", "max_range: 6", "max_range: 0.1",
              "sonar0/sensor.yaml", "more than min_range"},
        Break{"DepthWord", "pressure0/data.csv", "\n1600000000000000000,",
              "\n1600000000000000000,deep", "pressure0/data.csv:2", "depth is 'deep"},
        Break{"TruthColumns", "state_groundtruth_estimate0/data.csv", "\n1600000000200000000,",
              "\n1600000000200000000,1,", "state_groundtruth_estimate0/data.csv:3", "fields"},
        Break{"TruthFewColumns", "state_groundtruth_estimate0/data.csv", "\n1600000000200000000,",
              "\n1600000000200000000,1,2,3,1,0,0,0,5\n1600000000200000001,",
              "state_groundtruth_estimate0/data.csv:3", "must be 8 or 17"},
        Break{"TruthQuaternion", "state_groundtruth_estimate0/data.csv", "\n1600000000200000000,",
              "\n1600000000200000000,1,2,3,1,1,0,0\n1600000000200000001,",
              "state_groundtruth_estimate0/data.csv:3", "quaternion"},
        Break{"RigsDiffer", "cam0/sensor.yaml", "intrinsics: [575.3", "intrinsics: [575.4",
              "rig.yaml", "cam0"},
        Break{"ImuRangesDiffer", "imu0/sensor.yaml", "gyroscope_range: 5.236",
              "gyroscope_range: 5.3", "rig.yaml", "imu0"},
        Break{"PressureLagsDiffer", "pressure0/sensor.yaml", "depth_lag: 0.02", "depth_lag: 0.5",
              "rig.yaml", "pressure0"},
        Break{"ArrivalUnknownSensor", "arrivals.csv", ",imu0,", ",imu1,",
              "arrivals.csv:", "imu0, cam0"},
        Break{"ArrivalUnknownTime", "arrivals.csv", "1600000000050000000,", "1600000000050000001,",
              "arrivals.csv:", "row of imu0/data.csv"},
        Break{"ArrivalBeforeItsTime", "arrivals.csv", "1600000000050000000,1600000000050000000,",
              "1600000000050000000,1600000000049999999,", "arrivals.csv:", "at least the"},
        Break{"ArrivalsOutOfOrder", "arrivals.csv", "1600000000050000000,1600000000050000000,",
              "1600000000050000000,1600000009050000000,", "arrivals.csv:", "before it"},
        Break{"ArrivalMissing", "arrivals.csv", "1600000000050000000,1600000000050000000,imu0,1\n",
              "", "arrivals.csv", "never arrive"}),
    [](const auto& test) { return test.param.name; });

class EurocBrokenFiles : public RecordingTest {};

TEST_F(EurocBrokenFiles, NoRecordingAtAll) {
  EXPECT_THAT(ReadAll(folder_), HasSubstr("no recording in EuRoC's layout"));
  EXPECT_THAT(ReadAll(folder_ / "missing"), HasSubstr("missing: no such folder"));
}

TEST_F(EurocBrokenFiles, MissingFiles) {
  for (const char* file : {"imu0/sensor.yaml", "imu0/data.csv", "cam1/sensor.yaml", "cam0/data.csv",
                           "sonar0/data.csv", "pressure0/sensor.yaml"}) {
    Record(SmallDive());
    fs::remove(mav0() / file);
    EXPECT_THAT(ReadAll(target()), AllOf(HasSubstr(file), HasSubstr("no such file")));
  }
}

TEST_F(EurocBrokenFiles, ImagesThatAreNone) {
  const fs::path image = mav0() / "cam1/data/1600000000200000000.png";
  Record(SmallDive());
  WriteFileAtomically(image, "not a picture");
  EXPECT_THAT(ReadAll(target()), AllOf(HasSubstr(image.string()), HasSubstr("cannot be read")));
  cv::imwrite(image.string(), cv::Mat(24, 16, CV_8UC1, cv::Scalar(0)));
  EXPECT_THAT(ReadAll(target()), AllOf(HasSubstr(image.string()), HasSubstr("is 16x24 px")));
  // The head of a PNG that claims 2^31 - 1 pixels a side: refused before they are asked for.
  const std::string signature("\x89PNG\r\n\x1a\n", 8);
  WriteFileAtomically(
      image, signature + std::string("\0\0\0\x0dIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff", 16));
  EXPECT_THAT(ReadAll(target()), HasSubstr("is 2147483647x2147483647 px"));
  cv::imwrite(image.string(), cv::Mat(24, 32, CV_16UC1, cv::Scalar(0)));
  EXPECT_THAT(ReadAll(target()), AllOf(HasSubstr(image.string()), HasSubstr("8-bit")));
}

}  // namespace
}  // namespace drydock::dataset
