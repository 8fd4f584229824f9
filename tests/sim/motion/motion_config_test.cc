#include "sim/motion/motion_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock::sim {
namespace {

using drydock::testing::InputErrorOf;

MotionConfig Read(const std::string& text) {
  const YamlNode root = ParseYaml(text, "m.yaml");
  return ReadYaml(root, [](YamlReader& yaml) { return ReadMotion(yaml); });
}

TEST(MotionConfig, ReadsEverything) {
  const MotionConfig config = Read(
      "rest_s: 2.5\nspeed_m_s: 0.3\nclearance_m: 0.5\nsway: {position_m: 0.01, angle_deg: 18}\n"
      "waypoints:\n- {position_m: [0, 0, 0], yaw_offset_deg: 90, pitch_deg: -45}\n"
      "- {position_m: [1, 2, 3], look_at_m: [0, 5, 0]}\n");
  EXPECT_EQ(config.rest_s, 2.5);
  EXPECT_EQ(config.speed_m_s, 0.3);
  EXPECT_EQ(config.clearance_m, 0.5);
  EXPECT_NEAR(config.sway.angle_rad, 0.314159265, 1e-8);
  ASSERT_EQ(config.waypoints.size(), 2U);
  EXPECT_NEAR(config.waypoints[0].yaw_offset_rad, 1.57079633, 1e-8);
  EXPECT_NEAR(config.waypoints[0].pitch_rad, -0.78539816, 1e-8);
  EXPECT_EQ(*config.waypoints[1].look_at, Eigen::Vector3d(0, 5, 0));
}

TEST(MotionConfig, BrokenFilesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"waypoints: []\n", "m.yaml:1: waypoints"},
      {"waypoints:\n- {position_m: [0, 0, 0]}\n", "waypoints"},
      {"waypoints:\n- {position_m: [0, 0]}\n- {position_m: [1, 0, 0]}\n",
       "m.yaml:2: waypoints.0.position_m"},
      {"waypoints:\n- {position_m: [0, 0, 0]}\n- {position_m: [0, 0, 0.001]}\n",
       "m.yaml:3: waypoints.1.position_m"},
      {"waypoints:\n- {position_m: [0, 0, 0], look_at_m: [0, 0, 5]}\n- {position_m: [1, 0, 0]}\n",
       "look_at_m"},
      {"waypoints:\n- {position_m: [0, 0, 0], look_at_m: [1, 0, 5], pitch_deg: 3}\n- {position_m: "
       "[1, 0, 0]}\n",
       "look_at_m"},
      {"speed_m_s: 0\nwaypoints:\n- {position_m: [0, 0, 0]}\n- {position_m: [1, 0, 0]}\n",
       "m.yaml:1: speed_m_s"},
      {"sped_m_s: 1\nwaypoints:\n- {position_m: [0, 0, 0]}\n- {position_m: [1, 0, 0]}\n",
       "sped_m_s"},
  };
  for (const auto& entry : broken) {
    const std::string error = InputErrorOf([&] { Read(entry.first); });
    EXPECT_THAT(error, ::testing::HasSubstr(entry.second)) << entry.first;
  }
}

}  // namespace
}  // namespace drydock::sim
