// `drydock estimate --rig` on rigs that cannot be used. What reads them reads a scenario's rigs
// too.
#include "sensors_models/base/files.h"
#include "tests/integration/cli/broken_files.h"
#include "tests/integration/cli/recording.h"

namespace drydock::testing {
namespace {

constexpr const char* kRig = R"(name: small
stereo:
  rate_hz: 5
  cameras:
    - position_m: [0.04, 0.08, 0]
      quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]
      width_px: 320
      height_px: 240
      focal_px: [240, 240]
      principal_point_px: [160, 120]
      radtan: [-0.16, 0.1, 0, 0]
    - position_m: [0.04, -0.06, 0]
      quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]
      width_px: 320
      height_px: 240
      focal_px: [240, 240]
      principal_point_px: [160, 120]
      radtan: [-0.16, 0.1, 0, 0]
imu:
  rate_hz: 20
  gyro_noise_density_rad_s_sqrthz: 1.60e-4
  accel_noise_density_m_s2_sqrthz: 7.14e-4
  gyro_bias_walk_rad_s2_sqrthz: 1.65e-6
  accel_bias_walk_m_s3_sqrthz: 2.87e-5
  gyro_turn_on_bias_rad_s: 8.7e-4
  accel_turn_on_bias_m_s2: 1.96e-2
)";

constexpr const char* kThirdCamera = R"(    - position_m: [0, 0, 0]
      quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]
      width_px: 320
      height_px: 240
      focal_px: [240, 240]
      principal_point_px: [160, 120]
      radtan: [0, 0, 0, 0]
imu:)";

class BrokenRig : public BrokenFilesTest {
 protected:
  BrokenRig() {
    RecordGlide(inputs() / "glide");
    WriteFileAtomically(inputs() / "rig.yaml", kRig);
  }
};

TEST_P(BrokenRig, IsRefused) { ExpectRefusal(GetParam()); }

Broken Rig(const char* name, How how, const std::string& says) {
  return {name,
          {"estimate", "@glide", "--estimator", "dead-reckoning", "--start-from-truth", "--rig",
           "@rig.yaml", "-o", "result"},
          "rig.yaml",
          std::move(how),
          {"@rig.yaml" + says}};
}

const std::string kOneCamera =
    std::string(kRig).substr(std::string(kRig).rfind("    - pos"),
                             std::string(kRig).find("imu:") - std::string(kRig).rfind("    - pos"));

const Broken kRows[] = {
    Rig("QuaternionOfLengthTwo",
        Edit("quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]", "quaternion_xyzw: [-1, 1, -1, 1]"),
        ":6: stereo.cameras.0.quaternion_xyzw is a list, must be of length 1"),
    Rig("QuaternionOfThree", Edit("[-0.5, 0.5, -0.5, 0.5]", "[-0.5, 0.5, -0.5]"),
        ":6: stereo.cameras.0.quaternion_xyzw is a list, must be a list of 4 numbers"),
    Rig("OneCamera", Edit(kOneCamera, ""),
        ":4: stereo.cameras is a list, must be a list of two cameras"),
    Rig("ThreeCameras", Edit("imu:", kThirdCamera), ":19: stereo.cameras.2"),
    Rig("NoCameras", Edit("  cameras:\n", "  eyes:\n"), ":2: stereo.cameras is"),
    Rig("DifferentSizes", Edit("height_px: 240", "height_px: 200"),
        ":4: stereo.cameras is a list, must be a list of two cameras with images of the same size"),
    Rig("DistortionFolds", Edit("radtan: [-0.16, 0.1, 0, 0]", "radtan: [-1.5, 0, 0, 0]"),
        ":11: stereo.cameras.0.radtan: the distortion folds over"),
    Rig("FisheyeFolds", Edit("radtan: [-0.16, 0.1, 0, 0]", "equidistant: [-1.5, 0, 0, 0]"),
        ":11: stereo.cameras.0.equidistant: the distortion folds over"),
    Rig("TwoLenses",
        Edit("radtan: [-0.16, 0.1, 0, 0]", "radtan: [0, 0, 0, 0]\n      equidistant: [0, 0, 0, 0]"),
        ":12: stereo.cameras.0.equidistant is a list, must be left out beside radtan"),
    Rig("NoLens", Edit("      radtan: [-0.16, 0.1, 0, 0]\n", ""),
        ":5: a camera needs one of the keys 'radtan' and 'equidistant'"),
    Rig("DistortionOfFive", Edit("radtan: [-0.16, 0.1, 0, 0]", "radtan: [-0.16, 0.1, 0, 0, 0]"),
        ":11: stereo.cameras.0.radtan is a list, must be a list of 4 numbers"),
    Rig("NegativeRate", Edit("imu:\n  rate_hz: 20", "imu:\n  rate_hz: -20"),
        ":20: imu.rate_hz is -20, must be a number from 0.01 to 10000"),
    Rig("ZeroRate", Edit("rate_hz: 5", "rate_hz: 0"),
        ":3: stereo.rate_hz is 0, must be a number from"),
    Rig("EnormousRate", Edit("rate_hz: 5", "rate_hz: 1e300"),
        ":3: stereo.rate_hz is 1e300, must be a number from"),
    Rig("HalfAPixel", Edit("width_px: 320", "width_px: 320.5"),
        ":7: stereo.cameras.0.width_px is 320.5, must be a whole number"),
    Rig("QuotedNumber", Edit("width_px: 320", "width_px: '320'"),
        ":7: stereo.cameras.0.width_px is \"320\", must be a whole number"),
    Rig("NanNoise", Edit("1.60e-4", ".nan"),
        ":21: imu.gyro_noise_density_rad_s_sqrthz is .nan, must be a number"),
    Rig("NegativeNoise", Edit("1.60e-4", "-1.60e-4"),
        ":21: imu.gyro_noise_density_rad_s_sqrthz is -1.60e-4"),
    Rig("MissingImu", Edit("imu:", "inertial:"), ":1: the key 'imu' is missing"),
    Rig("UnknownKey", Append("magnetometer: {rate_hz: 10}\n"),
        ":27: unknown key 'magnetometer'; known here: depth, imu, name, sonar, stereo"),
    Rig("SonarBlind",
        Append("sonar: {rate_hz: 10, position_m: [0, 0, 0], quaternion_xyzw: [0, 0, 0, 1], "
               "step_deg: 1, min_range_m: 2, max_range_m: 1, range_noise_m: 0}\n"),
        ":27: sonar.max_range_m is 1, must be more than min_range_m"),
    Rig("Missing", Remove(), ": no such file"),
    Rig("AFolder", Folder(), ": is a folder"),
    Rig("AList", Whole("- a\n- b\n"), ": must be a mapping"),
};

INSTANTIATE_TEST_SUITE_P(All, BrokenRig, ::testing::ValuesIn(kRows), NameOf);

}  // namespace
}  // namespace drydock::testing
