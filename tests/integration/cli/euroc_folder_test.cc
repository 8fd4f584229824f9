// `drydock estimate` on folders made to the letter of EuRoC, with either lens and no start given.
#include "tests/integration/cli/euroc_folder.h"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sensors_models/base/files.h"
#include "tests/integration/cli/drydock_program.h"
#include "tests/support/temporary_folder.h"

namespace drydock::testing {
namespace {

/// 20 Hz and 200 Hz, wide lenses, an IMU as EuRoC's, neither sonar nor pressure sensor.
constexpr const char* kRig = R"(name: wide
stereo:
  rate_hz: 20
  imager: {{full_well_e: 8400, read_noise_e: 12, vignetting: 0.3, auto_exposure_time_s: 0.5}}
  cameras:
    - position_m: [0.062, 0.055, 0.011]
      quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]
      width_px: 480
      height_px: 300
      focal_px: [248.6, 248.1]
      principal_point_px: [237.9, 153.7]
      {}
    - position_m: [0.063, -0.055, 0.010]
      quaternion_xyzw: [-0.4960, 0.5010, -0.5035, 0.4995]
      width_px: 480
      height_px: 300
      focal_px: [247.6, 247.4]
      principal_point_px: [241.9, 147.2]
      {}
imu:
  rate_hz: 200
  gyro_noise_density_rad_s_sqrthz: 1.7e-4
  accel_noise_density_m_s2_sqrthz: 2.0e-3
  gyro_bias_walk_rad_s2_sqrthz: 1.9e-5
  accel_bias_walk_m_s3_sqrthz: 3.0e-3
  gyro_turn_on_bias_rad_s: 2.0e-3
  accel_turn_on_bias_m_s2: 2.0e-2
)";

struct Lenses {
  const char* name;
  const char* left;
  const char* right;
};

class CliEurocFolder : public ::testing::TestWithParam<Lenses> {};

INSTANTIATE_TEST_SUITE_P(
    All, CliEurocFolder,
    ::testing::Values(Lenses{"Radtan", "radtan: [-0.283, 0.074, 2.0e-4, 1.8e-5]",
                             "radtan: [-0.281, 0.073, -1.1e-4, -3.4e-5]"},
                      Lenses{"Equidistant", "equidistant: [-0.0132, 0.0208, -0.0125, 0.0026]",
                             "equidistant: [-0.0107, 0.0164, -0.0098, 0.0019]"}),
    [](const auto& test) { return std::string(test.param.name); });

// 0.8 m from rest in 6 s, of which the estimator's own start takes the first. Unlike ours their
// body has x up: its yaw about that axis is no heading.
TEST_P(CliEurocFolder, IsEstimatedFromItsOwnStart) {
  const TemporaryFolder folder;
  WriteFileAtomically(folder.path() / "rig.yaml",
                      fmt::format(kRig, GetParam().left, GetParam().right));
  const std::string scenario = std::string(DRYDOCK_SOURCE_DIR) + "/scenarios/bus.yaml";
  const std::string rig = "rig=" + (folder.path() / "rig.yaml").string();
  const Outcome simulated =
      RunDrydock(folder.path(), {"simulate", scenario, "--set", rig, "--set", "duration_s=6",
                                 "--set", "water.shadows=false", "-o", "dive"});
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  MakeLikeEuroc(folder.path() / "dive");
  const Outcome estimate =
      RunDrydock(folder.path(), {"estimate", "dive", "--estimator", "svin2-vio", "-o", "result"});
  ASSERT_EQ(estimate.exit_code, 0) << estimate.err;
  EXPECT_EQ(estimate.err, "");
  EXPECT_THAT(estimate.out,
              ::testing::HasSubstr("1322 measurements"));  // 1201 samples, 121 frames.
  const auto card = nlohmann::json::parse(ReadFile(folder.path() / "result" / "scorecard.json"));
  const auto& metrics = card["metrics"];
  EXPECT_LT(metrics["ate_rmse_m"], 0.004) << estimate.out;
  EXPECT_LT(std::abs(metrics["scale_error_percent"].get<double>()), 2.0);
  EXPECT_LT(metrics["yaw_error_deg"], 0.5);
  EXPECT_LT(metrics["final_drift_percent"], 2.0);
  EXPECT_LT(metrics["init_time_s"], 3.0);
  EXPECT_EQ(metrics["continuity_percent"], 100.0);
}

}  // namespace
}  // namespace drydock::testing
