#include "estimator/svin2/odometry/svin2_config.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock::svin2 {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::HasSubstr;

Svin2Config Read(const std::string& text) {
  return ReadSvin2Config(ParseYaml(text, "options.yaml"), {});
}

std::string ErrorOf(const std::string& text) {
  return InputErrorOf([&] { Read(text); });
}

TEST(Svin2Config, NothingSaidLeavesTheDefaults) {
  const Svin2Config config = Read("{}");
  EXPECT_TRUE(config.use_sonar);
  EXPECT_TRUE(config.use_depth);
  EXPECT_EQ(config.window.keyframes, 5);
  EXPECT_EQ(config.window.recent_frames, 3);
  EXPECT_FALSE(config.window.solver.seconds);  // Else results would hang on the machine.
}

TEST(Svin2Config, ReadsWhatIsSaid) {
  const Svin2Config config = Read(
      "use_sonar: false\nuse_depth: false\nimu_noise_inflation: 2.5\n"
      "window: {keyframes: 8, recent_frames: 4, iterations: 3, solver_time_s: 0.02}\n"
      "habit: {memory_s: 8, sigma_m_s: 0.2, correlation_s: 4}\n"
      "frontend: {preprocess: false}\ninitialiser: {min_landmarks: 20}\n");
  EXPECT_FALSE(config.use_sonar);
  EXPECT_FALSE(config.use_depth);
  EXPECT_EQ(config.imu_noise_inflation, 2.5);
  EXPECT_EQ(config.window.keyframes, 8);
  EXPECT_EQ(config.window.recent_frames, 4);
  EXPECT_EQ(config.window.solver.iterations, 3);
  EXPECT_EQ(config.window.solver.seconds, 0.02);
  EXPECT_EQ(config.habit.memory_s, 8.0);
  EXPECT_EQ(config.habit.sigma, 0.2);
  EXPECT_EQ(config.habit.correlation_s, 4.0);
  EXPECT_FALSE(config.frontend.preprocess);
  EXPECT_EQ(config.initialiser.min_landmarks, 20);
}

TEST(Svin2Config, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(ErrorOf("use_sonar: maybe\n"), HasSubstr("options.yaml:1"));
  EXPECT_THAT(ErrorOf("use_sonar: true\nuse_radar: true\n"), HasSubstr("options.yaml:2"));
  EXPECT_THAT(ErrorOf("window: {recent_frames: 1}\n"), HasSubstr("recent_frames"));
  EXPECT_THAT(ErrorOf("window: {frames: 1}\n"), HasSubstr("frames"));
  EXPECT_THAT(ErrorOf("window: {frames: 1}\n"), HasSubstr("solver_time_s"));
  EXPECT_THAT(ErrorOf("window: {solver_time_s: 0}\n"), HasSubstr("solver_time_s"));
}

}  // namespace
}  // namespace drydock::svin2
