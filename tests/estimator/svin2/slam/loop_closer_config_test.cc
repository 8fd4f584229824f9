#include "estimator/svin2/slam/loop_closer_config.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "tests/support/input_error.h"

namespace drydock::svin2 {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;

LoopCloserConfig Read(const std::string& text) {
  return ReadYaml(ParseYaml(text, "options.yaml"),
                  [](YamlReader& reader) { return ReadLoopCloserConfig(reader); });
}

std::string ErrorOf(const std::string& text) {
  return InputErrorOf([&] { Read(text); });
}

TEST(LoopCloserConfig, NothingSaidLeavesTheDefaults) {
  const LoopCloserConfig config = Read("{}");
  EXPECT_EQ(config.min_age_s, 10.0);
  EXPECT_EQ(config.candidates.neighbour_share, 0.1);
  EXPECT_EQ(config.max_verified, 3);
  EXPECT_EQ(config.nearby.max_candidates, 6);
  EXPECT_FALSE(config.graph.options.identity_weights);
  EXPECT_TRUE(config.graph.options.check_loops);
}

TEST(LoopCloserConfig, ReadsWhatIsSaid) {
  const LoopCloserConfig config = Read(
      "max_tracked: 12\nmin_age_s: 5\nneighbour_share: 0.6\nmin_score: 0.01\n"
      "consistent_keyframes: 3\nmax_verified: 1\nmin_inliers: 20\n"
      "step_sigma_factor: 1.5\ndelay_frames: 3\n"
      "nearby: {max_distance_m: 1, max_angle_rad: 0.3, max_drift_sigma_m: 0.2, max_candidates: 2}\n"
      "local_map_reach: 3\nidentity_weights: true\ncheck_loops: false\n");
  EXPECT_EQ(config.max_tracked, 12);
  EXPECT_EQ(config.min_age_s, 5.0);
  EXPECT_EQ(config.candidates.neighbour_share, 0.6);
  EXPECT_EQ(config.candidates.min_score, 0.01);
  EXPECT_EQ(config.consistency.required, 3);
  EXPECT_EQ(config.max_verified, 1);
  EXPECT_EQ(config.check.verifier.min_inliers, 20);
  EXPECT_EQ(config.check.relocaliser.min_inliers, 20);
  EXPECT_EQ(config.step_sigma_factor, 1.5);
  EXPECT_EQ(config.graph.delay_frames, 3);
  EXPECT_EQ(config.nearby.max_distance_m, 1.0);
  EXPECT_EQ(config.nearby.max_angle_rad, 0.3);
  EXPECT_EQ(config.nearby.max_drift_sigma_m, 0.2);
  EXPECT_EQ(config.nearby.max_candidates, 2);
  EXPECT_EQ(config.local_map.reach, 3);
  EXPECT_TRUE(config.graph.options.identity_weights);
  EXPECT_FALSE(config.graph.options.check_loops);
}

TEST(LoopCloserConfig, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(ErrorOf("max_verified: many\n"), HasSubstr("options.yaml:1"));
  EXPECT_THAT(ErrorOf("max_verified: 1\nmax_believed: 2\n"), HasSubstr("options.yaml:2"));
  EXPECT_THAT(ErrorOf("nearby: {max_distance_m: -1}\n"), HasSubstr("max_distance_m"));
  EXPECT_THAT(ErrorOf("min_age_s: 5\nnearby:\n  max_angle_deg: 30\n"),
              AllOf(HasSubstr("options.yaml:3"), HasSubstr("max_angle_deg")));
  EXPECT_THAT(ErrorOf("min_age_s: .nan\n"), HasSubstr("min_age_s"));
  EXPECT_THAT(ErrorOf("max_verified: 2.5\n"), HasSubstr("max_verified"));
  EXPECT_THAT(ErrorOf("check_loops: maybe\n"), HasSubstr("check_loops"));
  EXPECT_THAT(ErrorOf("min_inliers: 3\n"), HasSubstr("min_inliers"));
  EXPECT_THAT(ErrorOf("max_tracked: -1\n"), HasSubstr("max_tracked"));
}

}  // namespace
}  // namespace drydock::svin2
