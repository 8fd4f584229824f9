// Recordings that other programs wrote.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/dataset/euroc_reader.h"
#include "sensors_models/base/check.h"
#include "tests/scenarios/dataset/euroc_support.h"
#include "tests/support/input_error.h"

namespace drydock::dataset {
namespace {

using drydock::testing::InputErrorOf;

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class EurocForeign : public RecordingTest {
 protected:
  EurocForeign() {
    Record(SmallDive());
    for (const char* ours : {"rig.yaml", "arrivals.csv", "body.yaml", "sonar0", "pressure0"}) {
      fs::remove_all(mav0() / ours);
    }
  }

  EurocReader Open() {
    warnings_.clear();
    return EurocReader(target(), [this](const std::string& w) { warnings_.push_back(w); });
  }

  std::vector<std::string> warnings_;
};

TEST_F(EurocForeign, NeedsCamerasAndImuAlone) {
  const EurocReader reader = Open();
  EXPECT_THAT(warnings_, ::testing::IsEmpty());
  EXPECT_FALSE(reader.rig().HasSonar());
  EXPECT_FALSE(reader.rig().HasDepth());
  EXPECT_EQ(reader.rig().name, "dive");
  EXPECT_EQ(reader.size(), 49U);
}

TEST_F(EurocForeign, GoesByTimeAndTheImuFirst) {
  const EurocReader reader = Open();
  Time last{0};
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const Measurement measurement = reader.Read(i);
    EXPECT_EQ(measurement.t, measurement.t_arrival);
    EXPECT_GE(measurement.t, last);
    last = measurement.t;
  }
  EXPECT_TRUE(std::holds_alternative<ImuSample>(reader.Read(0).reading));
  EXPECT_TRUE(std::holds_alternative<StereoFrame>(reader.Read(1).reading));
}

TEST_F(EurocForeign, RigOfTheSheetsIsTheRig) {
  const Rig rig = Open().rig();
  const Rig expected = SmallRig();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(rig.stereo.T_IC[i].BoxMinus(expected.stereo.T_IC[i]).norm(), 1e-14);
    EXPECT_EQ(rig.stereo.cameras[i].fx, expected.stereo.cameras[i].fx);
    EXPECT_EQ(rig.stereo.cameras[i].distortion, expected.stereo.cameras[i].distortion);
  }
  EXPECT_EQ(rig.imu.accel_bias_walk, expected.imu.accel_bias_walk);
}

TEST_F(EurocForeign, TheRigsBodyIsTheImuWhereverTheirsIs) {
  // Their body lies 1 m above the IMU and is turned by a quarter about z.
  Edit("imu0/sensor.yaml", "data: [1, 0, 0, 0,\n         0, 1, 0, 0,\n         0, 0, 1, 0,",
       "data: [0, -1, 0, 0,\n         1, 0, 0, 0,\n         0, 0, 1, -1,");
  const Rig rig = Open().rig();
  const Pose T_BI(FromYawPitchRoll(M_PI / 2, 0.0, 0.0), {0.0, 0.0, -1.0});
  const Pose expected = T_BI.Inverse() * SmallRig().stereo.T_IC[0];
  EXPECT_LT(rig.stereo.T_IC[0].BoxMinus(expected).norm(), 1e-12);
}

TEST_F(EurocForeign, UnknownKeysAreWarnings) {
  Edit("cam0/sensor.yaml", "rate_hz:", "lens: good\nrate_hz:");
  Open();
  EXPECT_THAT(warnings_, ElementsAre(AllOf(HasSubstr("cam0/sensor.yaml:10"), HasSubstr("lens"))));
}

TEST_F(EurocForeign, OpenCvsDirectiveAndWindowsLinesAreTolerated) {
  Edit("imu0/sensor.yaml", "sensor_type", "%YAML:1.0\n---\nsensor_type");
  std::string text = ReadFile(mav0() / "imu0/data.csv");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  WriteFileAtomically(mav0() / "imu0/data.csv", text);
  EXPECT_EQ(Open().size(), 49U);
}

TEST_F(EurocForeign, ImagesWithoutPartnerAreLeftOutWithAWarning) {
  Edit("cam1/data.csv", "1600000000200000000,1600000000200000000.png\n", "");
  const EurocReader reader = Open();
  EXPECT_EQ(reader.size(), 48U);
  EXPECT_THAT(warnings_, ElementsAre(AllOf(HasSubstr("1 images"), HasSubstr("8 pairs remain"))));
}

TEST_F(EurocForeign, NoTruthIsNoError) {
  fs::remove_all(mav0() / "state_groundtruth_estimate0");
  EXPECT_TRUE(Open().ReadTruth().empty());
}

TEST_F(EurocForeign, TruthOfPosesAloneIsRead) {
  WriteFileAtomically(mav0() / "state_groundtruth_estimate0/data.csv",
                      "#timestamp,p,p,p,qw,q,q,q\n5,1,2,3,1,0,0,0\n");
  const auto truth = Open().ReadTruth();
  ASSERT_EQ(truth.size(), 1U);
  EXPECT_EQ(truth[0].state.T_WI.p(), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(truth[0].state.T_WI.q().w(), 1.0);
}

TEST_F(EurocForeign, EquidistantLensesAreRead) {
  Edit("cam0/sensor.yaml", "radial-tangential", "equidistant");
  Edit("cam0/sensor.yaml", "distortion_coefficients: [",
       "distortion_coefficients: [-3.5, 0, 0, 0] #");
  const Rig rig = Open().rig();
  EXPECT_EQ(rig.stereo.cameras[0].lens, LensModel::kEquidistant);
  EXPECT_EQ(rig.stereo.cameras[0].distortion, (std::array<double, 4>{-3.5, 0.0, 0.0, 0.0}));
  EXPECT_EQ(rig.stereo.cameras[1].lens, LensModel::kRadtan);
}

TEST_F(EurocForeign, OtherDistortionModelsAreAClearError) {
  Edit("cam0/sensor.yaml", "radial-tangential", "fov");
  const std::string error = InputErrorOf([&] { Open(); });
  EXPECT_THAT(error, AllOf(HasSubstr("cam0/sensor.yaml:14"), HasSubstr("is fov"),
                           HasSubstr("one of radial-tangential, equidistant")));
}

}  // namespace
}  // namespace drydock::dataset
