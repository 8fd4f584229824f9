// The visual front end's configuration as users write it.
#pragma once

#include "estimator/svin2/frontend/feature_tracker.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::svin2 {

/// Reads a mapping of the front end; all keys are optional and keep the defaults of
/// FeatureTracker::Config and of its parts. InputError names file, line and key.
///
///     matching: both              # patches | descriptors | both
///     octaves: 3
///     enough_points: 60
///     preprocess: true
///     memory_keyframes: 3
///     sigma_px: 0.05
///     sigma_per_unlikeness_px: 1.0
///     coarse_sigma_px: 0.38
///     preprocessor:
///       {denoise_sigma_px, background_sigma_px, adjust_contrast, low_percentile,
///        high_percentile, max_gain, clahe, clahe_clip_limit, clahe_tiles}
///     corners:
///       {max_corners, radius_px, border_px, window_sigma_px, min_score, min_quality,
///        refine_radius_px, max_refine_px}
///     coarse_corners: {as corners}
///     unfollowed: {corners, octave, enough_points, min_correlation}
///     descriptors: {pattern_radius_px, max_distance, max_ratio, radius_px}
///     flow:
///       {window_px, levels, max_forward_backward_px, patch_radius_px, affine, min_correlation,
///        max_align_px}
///     anchors:
///       {patch_radius_px, affine, min_correlation, max_align_px, max_scale, max_renewals}
///     stereo:
///       {min_depth_m, search_level, search_radius_px, min_search_correlation, max_epipolar_px}
///     gate:
///       {max_error_px, min_inliers, max_iterations, confidence, refinements, max_epipolar_px,
///        min_baseline_m}
///     keyframes: {max_overlap, max_match_ratio, min_tracked_share, min_points, min_gap,
///                 max_gap}
FeatureTracker::Config ReadFeatureTracker(YamlReader& yaml);

}  // namespace drydock::svin2
