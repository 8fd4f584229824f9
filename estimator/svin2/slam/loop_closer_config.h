// How loops are closed.
#pragma once

#include "estimator/svin2/loop/local_map.h"
#include "estimator/svin2/loop/loop_checker.h"
#include "estimator/svin2/places/candidate_consistency.h"
#include "estimator/svin2/places/place_database.h"
#include "estimator/svin2/pose_graph/delayed_pose_graph.h"
#include "sensors_models/base/yaml_reader.h"

namespace drydock::svin2 {

/// Keyframes that odometry and earlier loops have near the latest one: candidates besides those of
/// like looks, which in haze are few.
struct NearbyRule {
  double max_distance_m = 1.5;
  double max_angle_rad = 0.5;
  /// Odometry is asked only while it cannot have drifted by more than this since [m].
  double max_drift_sigma_m = 0.3;
  int max_candidates = 6;  ///< The nearest.
};

struct LoopCloserConfig {
  /// Keyframes of the last moments are no candidates: of them odometry knows all that there is to
  /// know. Neither are those of which so many points are still tracked, which the window knows.
  double min_age_s = 10.0;
  int max_tracked = 10;
  /// Looks alone tell places apart weakly: geometry decides, so most candidates may come to it.
  LoopCandidateRule candidates = {.neighbour_share = 0.1, .min_score = 0.01};
  CandidateConsistency::Config consistency = {.max_gap = 3, .required = 1};
  int max_verified = 3;     ///< Candidates by looks that are verified, the best first,
  int max_pairs = 100'000;  ///< and more of them while so few pairs of points are to be compared.
  NearbyRule nearby;
  /// Odometry's steps from keyframe to keyframe have errors that are alike, so that they add up to
  /// more than their covariances do: standard deviations count so many times. Measured, see
  /// docs/models.md.
  double step_sigma_factor = 3.0;
  int index_level = 2;       ///< Points are compared below one node, so many steps from the root.
  LocalMapConfig local_map;  ///< In which geometry looks for the points of a candidate's place.
  LoopChecker::Config check;
  DelayedPoseGraphConfig graph;
};

/// Reads the options `loops` over the defaults.
LoopCloserConfig ReadLoopCloserConfig(YamlReader& reader);

}  // namespace drydock::svin2
