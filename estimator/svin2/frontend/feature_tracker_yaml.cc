#include "estimator/svin2/frontend/feature_tracker_yaml.h"

#include <string>
#include <string_view>

namespace drydock::svin2 {
namespace {

constexpr Bounds kShare = {0.0, 1.0};
constexpr Bounds kPixels = {0.0, 1000.0};

int IntegerOr(YamlReader& yaml, std::string_view key, Bounds bounds, int default_value) {
  return static_cast<int>(yaml.Integer(key, bounds, default_value));
}

Preprocessor::Config ReadPreprocessor(YamlReader& yaml, Preprocessor::Config c) {
  c.denoise_sigma_px = yaml.Real("denoise_sigma_px", {0.0, 5.0}, c.denoise_sigma_px);
  c.background_sigma_px = yaml.Real("background_sigma_px", {0.0, 1000.0}, c.background_sigma_px);
  c.adjust_contrast = yaml.Boolean("adjust_contrast", c.adjust_contrast);
  c.low_percentile = yaml.Real("low_percentile", {0.0, 100.0}, c.low_percentile);
  c.high_percentile = yaml.Real("high_percentile", {0.0, 100.0}, c.high_percentile);
  if (c.low_percentile >= c.high_percentile) {
    yaml.Fail("high_percentile", "a number above low_percentile");
  }
  c.max_gain = yaml.Real("max_gain", {1.0, 255.0}, c.max_gain);
  c.clahe = yaml.Boolean("clahe", c.clahe);
  c.clahe_clip_limit = yaml.Real("clahe_clip_limit", {1.0, 256.0}, c.clahe_clip_limit);
  c.clahe_tiles = IntegerOr(yaml, "clahe_tiles", {1, 64}, c.clahe_tiles);
  return c;
}

CornerDetector::Config ReadCorners(YamlReader& yaml, CornerDetector::Config c) {
  c.max_corners = IntegerOr(yaml, "max_corners", {1, 10000}, c.max_corners);
  c.radius_px = yaml.Real("radius_px", {1.0, 1000.0}, c.radius_px);
  c.border_px = IntegerOr(yaml, "border_px", {1, 1000}, c.border_px);
  c.window_sigma_px = yaml.Real("window_sigma_px", {0.1, 5.0}, c.window_sigma_px);
  c.min_score = yaml.Real("min_score", Bounds::NotNegative(), c.min_score);
  c.min_quality = yaml.Real("min_quality", kShare, c.min_quality);
  c.refine_radius_px = IntegerOr(yaml, "refine_radius_px", {0, 50}, c.refine_radius_px);
  if (c.refine_radius_px >= c.border_px) {
    yaml.Fail("refine_radius_px", "a number below border_px");
  }
  c.max_refine_px = yaml.Real("max_refine_px", kPixels, c.max_refine_px);
  return c;
}

void ReadDescriptors(YamlReader& yaml, FeatureTracker::Config& config) {
  auto& radius = config.descriptor.pattern_radius_px;
  radius = yaml.Real("pattern_radius_px", {5.0, 100.0}, radius);
  DescriptorMatcher::Config& c = config.descriptor_matcher;
  c.max_distance = IntegerOr(yaml, "max_distance", {0, 512}, c.max_distance);
  c.max_ratio = yaml.Real("max_ratio", {0.01, 1.0}, c.max_ratio);
  c.radius_px = yaml.Real("radius_px", {0.1, 10000.0}, c.radius_px);
}

PatchTracker::Config ReadFlow(YamlReader& yaml, PatchTracker::Config c) {
  c.window_px = IntegerOr(yaml, "window_px", {5, 101}, c.window_px);
  if (c.window_px % 2 == 0) yaml.Fail("window_px", "an odd number");
  c.levels = IntegerOr(yaml, "levels", {1, 8}, c.levels);
  c.max_forward_backward_px =
      yaml.Real("max_forward_backward_px", kPixels, c.max_forward_backward_px);
  c.patch_radius_px = IntegerOr(yaml, "patch_radius_px", {0, 50}, c.patch_radius_px);
  c.affine = yaml.Boolean("affine", c.affine);
  c.min_correlation = yaml.Real("min_correlation", kShare, c.min_correlation);
  c.max_align_px = yaml.Real("max_align_px", kPixels, c.max_align_px);
  return c;
}

AnchorTracker::Config ReadAnchors(YamlReader& yaml, AnchorTracker::Config c) {
  c.patch_radius_px = IntegerOr(yaml, "patch_radius_px", {2, 50}, c.patch_radius_px);
  c.affine = yaml.Boolean("affine", c.affine);
  c.min_correlation = yaml.Real("min_correlation", kShare, c.min_correlation);
  c.max_align_px = yaml.Real("max_align_px", kPixels, c.max_align_px);
  c.max_scale = yaml.Real("max_scale", {1.01, 100.0}, c.max_scale);
  c.max_renewals = IntegerOr(yaml, "max_renewals", {0, 1000000}, c.max_renewals);
  return c;
}

StereoMatcher::Config ReadStereo(YamlReader& yaml, StereoMatcher::Config c) {
  c.min_depth_m = yaml.Real("min_depth_m", {0.01, 1000.0}, c.min_depth_m);
  c.search_level = IntegerOr(yaml, "search_level", {0, 7}, c.search_level);
  c.search_radius_px = IntegerOr(yaml, "search_radius_px", {1, 50}, c.search_radius_px);
  c.min_search_correlation = yaml.Real("min_search_correlation", kShare, c.min_search_correlation);
  c.max_epipolar_px = yaml.Real("max_epipolar_px", kPixels, c.max_epipolar_px);
  return c;
}

TrackGate::Config ReadGate(YamlReader& yaml, TrackGate::Config c) {
  RigRansacConfig& ransac = c.ransac;
  ransac.max_error_px = yaml.Real("max_error_px", {0.1, 1000.0}, ransac.max_error_px);
  ransac.min_inliers = IntegerOr(yaml, "min_inliers", {3, 10000}, ransac.min_inliers);
  ransac.max_iterations = IntegerOr(yaml, "max_iterations", {0, 100000}, ransac.max_iterations);
  ransac.confidence = yaml.Real("confidence", {0.5, 0.999999}, ransac.confidence);
  ransac.refinements = IntegerOr(yaml, "refinements", {0, 1000}, ransac.refinements);
  c.max_epipolar_px = yaml.Real("max_epipolar_px", kPixels, c.max_epipolar_px);
  c.min_baseline_m = yaml.Real("min_baseline_m", {0.0, 1000.0}, c.min_baseline_m);
  return c;
}

KeyframeRule::Config ReadKeyframes(YamlReader& yaml, KeyframeRule::Config c) {
  c.max_overlap = yaml.Real("max_overlap", kShare, c.max_overlap);
  c.max_match_ratio = yaml.Real("max_match_ratio", kShare, c.max_match_ratio);
  c.min_tracked_share = yaml.Real("min_tracked_share", kShare, c.min_tracked_share);
  c.min_points = IntegerOr(yaml, "min_points", {0, 10000}, c.min_points);
  c.min_gap = IntegerOr(yaml, "min_gap", {1, 1000000}, c.min_gap);
  c.max_gap = IntegerOr(yaml, "max_gap", {1, 1000000}, c.max_gap);
  if (c.max_gap < c.min_gap) yaml.Fail("max_gap", "a number not below min_gap");
  return c;
}

UnfollowedCorners::Config ReadUnfollowed(YamlReader& yaml, UnfollowedCorners::Config c) {
  yaml.OptionalMap("corners", [&](YamlReader& map) { c.detector = ReadCorners(map, c.detector); });
  c.octave = IntegerOr(yaml, "octave", {0, 7}, c.octave);
  c.enough_points = IntegerOr(yaml, "enough_points", {0, 100000}, c.enough_points);
  c.min_correlation = yaml.Real("min_correlation", kShare, c.min_correlation);
  return c;
}

Matching ReadMatching(YamlReader& yaml) {
  const std::string name = yaml.Choice("matching", {"patches", "descriptors", "both"}, "both");
  if (name == "patches") return Matching::kPatches;
  return name == "descriptors" ? Matching::kDescriptors : Matching::kBoth;
}

}  // namespace

FeatureTracker::Config ReadFeatureTracker(YamlReader& yaml) {
  FeatureTracker::Config c;
  c.matching = ReadMatching(yaml);
  c.octaves = IntegerOr(yaml, "octaves", {1, 8}, c.octaves);
  c.enough_points = IntegerOr(yaml, "enough_points", {0, 100000}, c.enough_points);
  c.preprocess = yaml.Boolean("preprocess", c.preprocess);
  c.memory_keyframes = IntegerOr(yaml, "memory_keyframes", {0, 100}, c.memory_keyframes);
  KeypointSigma& sigma = c.sigma;
  sigma.recognised_px = yaml.Real("sigma_px", {0.001, 100.0}, sigma.recognised_px);
  sigma.per_unlikeness_px =
      yaml.Real("sigma_per_unlikeness_px", {0.0, 100.0}, sigma.per_unlikeness_px);
  sigma.coarse_px = yaml.Real("coarse_sigma_px", {0.001, 100.0}, sigma.coarse_px);
  yaml.OptionalMap("preprocessor", [&](YamlReader& map) {
    c.preprocessor = ReadPreprocessor(map, c.preprocessor);
  });
  yaml.OptionalMap("corners", [&](YamlReader& map) { c.detector = ReadCorners(map, c.detector); });
  yaml.OptionalMap("coarse_corners", [&](YamlReader& map) {
    c.coarse_detector = ReadCorners(map, c.coarse_detector);
  });
  yaml.OptionalMap("unfollowed",
                   [&](YamlReader& map) { c.unfollowed = ReadUnfollowed(map, c.unfollowed); });
  yaml.OptionalMap("descriptors", [&](YamlReader& map) { ReadDescriptors(map, c); });
  yaml.OptionalMap("flow", [&](YamlReader& map) { c.patches = ReadFlow(map, c.patches); });
  yaml.OptionalMap("anchors", [&](YamlReader& map) { c.anchors = ReadAnchors(map, c.anchors); });
  yaml.OptionalMap("stereo", [&](YamlReader& map) { c.stereo = ReadStereo(map, c.stereo); });
  yaml.OptionalMap("gate", [&](YamlReader& map) { c.gate = ReadGate(map, c.gate); });
  yaml.OptionalMap("keyframes",
                   [&](YamlReader& map) { c.keyframes = ReadKeyframes(map, c.keyframes); });
  return c;
}

}  // namespace drydock::svin2
