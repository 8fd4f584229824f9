#include "sensors_models/measurement/rig.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/support/input_error.h"

namespace drydock {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Rig, Svin2Version3Loads) {
  const Rig rig = LoadRig(FindRig("svin2_v3"));
  EXPECT_EQ(rig.name, "svin2_v3");
  EXPECT_EQ(rig.stereo.rate_hz, 15.0);
  EXPECT_EQ(rig.stereo.cameras[0].width, 800);
  EXPECT_EQ(rig.stereo.cameras[1].height, 600);
  EXPECT_EQ(rig.imu.rate_hz, 100.0);
  ASSERT_TRUE(rig.HasSonar());
  ASSERT_TRUE(rig.HasDepth());
  EXPECT_DOUBLE_EQ(rig.sonar.step_rad, 0.9 * std::numbers::pi / 180.0);
}

TEST(Rig, Svin2Version3LooksForwardAndScansAcross) {
  const Rig rig = LoadRig(FindRig("svin2_v3"));
  for (const Pose& T_IC : rig.stereo.T_IC) {
    // The camera's z is the body's x, its x is right (-y), its y is down (-z).
    EXPECT_LT((T_IC.q() * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
    EXPECT_LT((T_IC.q() * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_LT((T_IC.q() * Eigen::Vector3d::UnitY() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
  const Eigen::Vector3d axis = rig.sonar.T_IS.q() * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(std::abs(axis.x()), 1.0, 1e-12);
  // The left camera is on the left.
  EXPECT_GT(rig.stereo.T_IC[0].p().y(), rig.stereo.T_IC[1].p().y());
}

TEST(Rig, Aqua2LooksForwardAndDownAndHasNoSonar) {
  const Rig rig = LoadRig(FindRig("aqua2"));
  EXPECT_FALSE(rig.HasSonar());
  EXPECT_TRUE(rig.HasDepth());
  for (const Pose& T_IC : rig.stereo.T_IC) {
    // 30 degrees: the camera's z is forward (x) and half as much down, its x is right (-y).
    const Eigen::Vector3d ahead(std::sqrt(0.75), 0.0, -0.5);
    EXPECT_LT((T_IC.q() * Eigen::Vector3d::UnitZ() - ahead).norm(), 1e-6);
    EXPECT_LT((T_IC.q() * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitY()).norm(), 1e-6);
  }
  const Eigen::Vector3d baseline = rig.stereo.T_IC[1].p() - rig.stereo.T_IC[0].p();
  EXPECT_NEAR(baseline.y(), -0.088, 1e-9);
}

// 300 deg/s, 5 g, 0.008 deg/s, 0.1 mg and 0.05 deg.
TEST(Rig, Svin2Version3HasLimits) {
  const Rig rig = LoadRig(FindRig("svin2_v3"));
  constexpr double kDegree = std::numbers::pi / 180.0;
  EXPECT_NEAR(rig.imu.gyro_range, 300.0 * kDegree, 1e-3);
  EXPECT_NEAR(rig.imu.accel_range, 5.0 * 9.80665, 1e-2);
  EXPECT_NEAR(rig.imu.gyro_resolution, 0.008 * kDegree, 1e-6);
  EXPECT_NEAR(rig.imu.accel_resolution, 1e-4 * 9.80665, 1e-6);
  EXPECT_NEAR(rig.imu.gyro_misalignment, 0.05 * kDegree, 1e-5);
  EXPECT_EQ(rig.imu.gyro_misalignment, rig.imu.accel_misalignment);
  EXPECT_EQ(rig.imu.gyro_scale_error, 5e-4);
  EXPECT_EQ(rig.imu.accel_scale_error, 5e-4);
  EXPECT_EQ(rig.depth.offset_m, 0.5);
  EXPECT_EQ(rig.depth.lag_s, 0.02);
  EXPECT_EQ(rig.depth.resolution_m, 0.002);
}

TEST(Rig, EachCameraHasALensOfItsOwn) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  const auto right = text.rfind("radtan:");
  text.replace(right, text.find('\n', right) - right, "equidistant: [0.1, -3, 4, 0.5]");
  const Rig rig = ReadRig(ParseYaml(text, "mixed.yaml"));
  EXPECT_EQ(rig.stereo.cameras[0].lens, LensModel::kRadtan);
  EXPECT_EQ(rig.stereo.cameras[1].lens, LensModel::kEquidistant);
  EXPECT_EQ(rig.stereo.cameras[1].distortion, (std::array<double, 4>{0.1, -3.0, 4.0, 0.5}));
}

/// `text` without the lines from the one that has `first` to the one that has `last`.
std::string WithoutLines(const std::string& text, const std::string& first,
                         const std::string& last) {
  const auto begin = text.rfind('\n', text.find(first)) + 1;
  const auto end = text.find('\n', text.find(last)) + 1;
  return text.substr(0, begin) + text.substr(end);
}

TEST(Rig, WhatASheetNeedNotSayIsNone) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  text = WithoutLines(text, "gyro_scale_error", "accel_resolution_m_s2");
  text = WithoutLines(text, "  offset_m", "resolution_m:");
  const Rig rig = ReadRig(ParseYaml(text, "short.yaml"));
  for (const double value :
       {rig.imu.gyro_scale_error, rig.imu.accel_scale_error, rig.imu.gyro_misalignment,
        rig.imu.accel_misalignment, rig.imu.gyro_range, rig.imu.accel_range,
        rig.imu.gyro_resolution, rig.imu.accel_resolution, rig.depth.offset_m, rig.depth.lag_s,
        rig.depth.resolution_m}) {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(Rig, KnownRigsCanBeFound) {
  const std::vector<std::string> known = KnownRigs();
  EXPECT_THAT(known, ::testing::Contains("svin2_v3"));
  for (const std::string& name : known) EXPECT_NO_THROW(LoadRig(FindRig(name))) << name;
}

TEST(Rig, UnknownNameIsAnError) {
  EXPECT_THROW(FindRig("no_such_rig"), InputError);
  EXPECT_EQ(FindRig("some/where.yaml"), "some/where.yaml");
  EXPECT_THROW(LoadRig("some/where.yaml"), InputError);
}

struct Edit {
  const char* name;
  const char* from;
  const char* to;
  const char* says;
};

class BrokenRig : public ::testing::TestWithParam<Edit> {};

TEST_P(BrokenRig, IsNamedWithFileAndLine) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  const auto at = text.find(GetParam().from);
  ASSERT_NE(at, std::string::npos) << GetParam().from;
  text.replace(at, std::string(GetParam().from).size(), GetParam().to);
  const std::string error = InputErrorOf([&] { ReadRig(ParseYaml(text, "broken.yaml")); });
  EXPECT_THAT(error, AllOf(HasSubstr("broken.yaml"), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    Edits, BrokenRig,
    ::testing::Values(
        Edit{"NoName", "name: svin2_v3", "", "'name'"},
        Edit{"MissingKey", "  rate_hz: 15\n", "", "stereo.rate_hz"},
        Edit{"UnknownKey", "stereo:\n", "stereo:\n  fov_deg: 3\n", "fov_deg"},
        Edit{"UnknownSensor", "depth:", "deepth:", "deepth"},
        Edit{"ZeroRate", "rate_hz: 15", "rate_hz: 0", "stereo.rate_hz is 0"},
        Edit{"Quaternion", "[-0.5, 0.5, -0.5, 0.5]", "[-0.5, 0.5, -0.5, 0.6]", "of length 1"},
        Edit{"ThreeNumbers", "[-0.5, 0.5, -0.5, 0.5]", "[-0.5, 0.5, -0.5]", "4 numbers"},
        Edit{"FarAway", "[0.040, 0.084, -0.005]", "[40.0, 0.084, -0.005]", "position_m.0"},
        Edit{"TwoSizes", "width_px: 800", "width_px: 400", "same size"},
        Edit{"NoLens", "      radtan: [-0.160, 0.102, 0.0, 0.0]\n", "",
             "broken.yaml:21: a camera needs one of the keys 'radtan' and 'equidistant'"},
        Edit{"TwoLenses", "      radtan: [-0.160, 0.102, 0.0, 0.0]\n",
             "      radtan: [0, 0, 0, 0]\n      equidistant: [0, 0, 0, 0]\n",
             "broken.yaml:28: stereo.cameras.0.equidistant is a list, must be left out beside "
             "radtan"},
        Edit{"FiveOfALens", "radtan: [-0.160, 0.102, 0.0, 0.0]", "equidistant: [0, 0, 0, 0, 0]",
             "broken.yaml:27: stereo.cameras.0.equidistant is a list, must be a list of 4 numbers"},
        Edit{"HugeFisheye", "radtan: [-0.160, 0.102, 0.0, 0.0]", "equidistant: [0, 21, 0, 0]",
             "stereo.cameras.0.equidistant.1 is 21, must be a number from -20 to 20"},
        Edit{"HugeRadtan", "radtan: [-0.160, 0.102, 0.0, 0.0]", "radtan: [0, 21, 0, 0]",
             "stereo.cameras.0.radtan.1 is 21, must be a number from -2 to 2"},
        Edit{"LensByAnotherName", "radtan: [-0.160", "fisheye: [-0.160",
             "broken.yaml:21: a camera needs one of the keys"},
        Edit{"Focal", "[575.3, 574.6]", "[575.3, -574.6]", "focal_px.1"},
        Edit{"Nan", "1.60e-4", ".nan", "gyro_noise_density_rad_s_sqrthz"},
        Edit{"Ranges", "max_range_m: 6.0", "max_range_m: 0.1", "more than min_range_m"},
        Edit{"Step", "step_deg: 0.9", "step_deg: 0", "step_deg is 0"},
        Edit{"ScaleError", "gyro_scale_error: 5.0e-4", "gyro_scale_error: 5.0", "from 0 to 0.1"},
        Edit{"Misalignment", "accel_misalignment_rad: 8.7e-4", "accel_misalignment_rad: -1e-4",
             "imu.accel_misalignment_rad"},
        Edit{"GyroSteps", "gyro_resolution_rad_s: 1.4e-4", "gyro_resolution_rad_s: 9",
             "at most gyro_range_rad_s"},
        Edit{"AccelSteps", "accel_resolution_m_s2: 9.8e-4", "accel_resolution_m_s2: 99",
             "at most accel_range_m_s2"},
        Edit{"Lag", "lag_s: 0.02", "lag_s: -0.02", "depth.lag_s"},
        Edit{"Beam", "beam_width_deg: 1.4", "beam_width_deg: -1.4", "sonar.beam_width_deg"},
        Edit{"Bins", "bins: 255", "bins: 25.5", "sonar.bins"},
        Edit{"Incidence", "incidence_exponent: 2", "incidence_exponent: 0", "from 1 to 20"},
        Edit{"Dropouts", "dropout_probability: 0.01", "dropout_probability: 1.1", "from 0 to 1"},
        Edit{"Quoted", "noise_m: 0.002", "noise_m: '0.002'", "depth.noise_m"}),
    [](const auto& test) { return test.param.name; });

TEST(Rig, SonarAndDepthMayBeMissing) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  text.erase(text.find("sonar:"));
  const Rig rig = ReadRig(ParseYaml(text, "small.yaml"));
  EXPECT_FALSE(rig.HasSonar());
  EXPECT_FALSE(rig.HasDepth());
}

// A rig from before the sonar had an echo: one exact ray with white noise.
TEST(Rig, TheSonarsEchoMayBeMissing) {
  std::string text = ReadFile(FindRig("svin2_v3"));
  const auto first = text.find("  beam_width_deg");
  text.erase(first, text.find("\n# Bluerobotics") - first);
  const SonarSheet sonar = ReadRig(ParseYaml(text, "plain.yaml")).sonar;
  EXPECT_EQ(sonar.range_noise_m, 0.01);
  EXPECT_EQ(sonar.bins, 0);
  EXPECT_EQ(sonar.beam_width_rad, 0.0);
  EXPECT_EQ(sonar.speckle_looks, 0);
  EXPECT_EQ(sonar.dropout_probability, 0.0);
  EXPECT_EQ(sonar.incidence_exponent, 2.0);
}

TEST(Rig, OneAndThreeCamerasAreRefused) {
  const std::string text = ReadFile(FindRig("svin2_v3"));
  const auto first = text.find("    - position_m");
  const auto second = text.find("    - position_m", first + 1);
  const auto end = text.find("\n# Microstrain");
  const std::string camera = text.substr(second, end - second);
  EXPECT_THROW(ReadRig(ParseYaml(text.substr(0, second) + text.substr(end), "one.yaml")),
               InputError);
  EXPECT_THROW(ReadRig(ParseYaml(text.substr(0, end) + camera + text.substr(end), "three.yaml")),
               InputError);
}

}  // namespace
}  // namespace drydock
