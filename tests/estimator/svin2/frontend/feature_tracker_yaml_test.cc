#include "estimator/svin2/frontend/feature_tracker_yaml.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/yaml_node.h"
#include "tests/estimator/svin2/frontend/synthetic_dive.h"
#include "tests/support/input_error.h"

namespace drydock::svin2 {
namespace {

using drydock::testing::InputErrorOf;

using ::testing::HasSubstr;

FeatureTracker::Config Read(const std::string& text) {
  const YamlNode root = ParseYaml(text, "f.yaml");
  return ReadYaml(root, ReadFeatureTracker);
}

std::string MessageOf(const std::string& text) {
  return InputErrorOf([&] { Read(text); });
}

TEST(FeatureTrackerYaml, NothingSaidIsTheDefault) {
  const FeatureTracker::Config read = Read("{}"), meant;
  EXPECT_EQ(read.matching, meant.matching);
  EXPECT_EQ(read.detector.min_score, meant.detector.min_score);
  EXPECT_EQ(read.octaves, meant.octaves);
  EXPECT_EQ(read.coarse_detector.radius_px, meant.coarse_detector.radius_px);
  EXPECT_EQ(read.anchors.patch_radius_px, meant.anchors.patch_radius_px);
  EXPECT_EQ(read.keyframes.min_tracked_share, meant.keyframes.min_tracked_share);
  // The defaults serve.
  EXPECT_NO_THROW(FeatureTracker(read, testing::HalfRig()));
}

TEST(FeatureTrackerYaml, ReadsEveryPart) {
  const FeatureTracker::Config c = Read(R"(
matching: descriptors
preprocess: false
memory_keyframes: 2
sigma_px: 0.5
sigma_per_unlikeness_px: 0.25
octaves: 2
enough_points: 50
coarse_sigma_px: 0.2
coarse_corners: {radius_px: 9}
unfollowed: {corners: {radius_px: 7}, octave: 1, enough_points: 70, min_correlation: 0.6}
preprocessor: {denoise_sigma_px: 1.5, background_sigma_px: 20, clahe: false}
corners: {max_corners: 123, min_score: 0.001}
descriptors: {pattern_radius_px: 20, max_distance: 70, max_ratio: 0.9, radius_px: 12}
flow: {window_px: 15, levels: 3}
anchors: {patch_radius_px: 9, affine: false}
stereo: {min_depth_m: 0.7}
gate: {max_error_px: 2, max_epipolar_px: 1.25}
keyframes: {max_overlap: 0.5, min_gap: 4}
)");
  EXPECT_EQ(c.matching, Matching::kDescriptors);
  EXPECT_FALSE(c.preprocess);
  EXPECT_EQ(c.memory_keyframes, 2);
  EXPECT_EQ(c.sigma.recognised_px, 0.5);
  EXPECT_EQ(c.sigma.per_unlikeness_px, 0.25);
  EXPECT_EQ(c.octaves, 2);
  EXPECT_EQ(c.enough_points, 50);
  EXPECT_EQ(c.sigma.coarse_px, 0.2);
  EXPECT_EQ(c.coarse_detector.radius_px, 9.0);
  EXPECT_EQ(c.unfollowed.octave, 1);
  EXPECT_EQ(c.unfollowed.enough_points, 70);
  EXPECT_EQ(c.unfollowed.min_correlation, 0.6);
  EXPECT_EQ(c.unfollowed.detector.radius_px, 7.0);
  EXPECT_EQ(c.preprocessor.denoise_sigma_px, 1.5);
  EXPECT_EQ(c.preprocessor.background_sigma_px, 20.0);
  EXPECT_FALSE(c.preprocessor.clahe);
  EXPECT_EQ(c.detector.max_corners, 123);
  EXPECT_EQ(c.detector.min_score, 0.001);
  EXPECT_EQ(c.descriptor.pattern_radius_px, 20.0);
  EXPECT_EQ(c.descriptor_matcher.max_distance, 70);
  EXPECT_EQ(c.descriptor_matcher.max_ratio, 0.9);
  EXPECT_EQ(c.descriptor_matcher.radius_px, 12.0);
  EXPECT_EQ(c.patches.window_px, 15);
  EXPECT_EQ(c.patches.levels, 3);
  EXPECT_EQ(c.anchors.patch_radius_px, 9);
  EXPECT_FALSE(c.anchors.affine);
  EXPECT_EQ(c.stereo.min_depth_m, 0.7);
  EXPECT_EQ(c.gate.ransac.max_error_px, 2.0);
  EXPECT_EQ(c.gate.max_epipolar_px, 1.25);
  EXPECT_EQ(c.keyframes.max_overlap, 0.5);
  EXPECT_EQ(c.keyframes.min_gap, 4);
}

TEST(FeatureTrackerYaml, NamesThePlaceOfAMistake) {
  EXPECT_THAT(MessageOf("corners: {max_corner: 5}"), HasSubstr("max_corner"));
  EXPECT_THAT(MessageOf("matching: guess"), HasSubstr("patches"));
  EXPECT_THAT(MessageOf("flow:\n  window_px: 20"), HasSubstr("f.yaml:2"));
  EXPECT_THAT(MessageOf("flow:\n  window_px: 20"), HasSubstr("odd"));
  EXPECT_THAT(MessageOf("corners: {border_px: 4}"), HasSubstr("border_px"));
  EXPECT_THAT(MessageOf("preprocessor: {high_percentile: 0.1}"), HasSubstr("low_percentile"));
  EXPECT_THAT(MessageOf("keyframes: {max_gap: 2}"), HasSubstr("min_gap"));
}

}  // namespace
}  // namespace drydock::svin2
