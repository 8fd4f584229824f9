#include "estimator/svin2/slam/loop_closer_config.h"

namespace drydock::svin2 {
namespace {

void ReadNearby(YamlReader& reader, NearbyRule& nearby) {
  nearby.max_distance_m =
      reader.Real("max_distance_m", Bounds::NotNegative(), nearby.max_distance_m);
  nearby.max_angle_rad = reader.Real("max_angle_rad", Bounds::NotNegative(), nearby.max_angle_rad);
  nearby.max_drift_sigma_m =
      reader.Real("max_drift_sigma_m", Bounds::NotNegative(), nearby.max_drift_sigma_m);
  nearby.max_candidates =
      static_cast<int>(reader.Integer("max_candidates", {0, 1000}, nearby.max_candidates));
}

}  // namespace

LoopCloserConfig ReadLoopCloserConfig(YamlReader& reader) {
  LoopCloserConfig config;
  const auto integer = [&](const char* key, double low, double high, int value) {
    return static_cast<int>(reader.Integer(key, {low, high}, value));
  };
  config.min_age_s = reader.Real("min_age_s", Bounds::NotNegative(), config.min_age_s);
  config.max_tracked = integer("max_tracked", 0, 10'000, config.max_tracked);
  config.candidates.neighbour_share =
      reader.Real("neighbour_share", {0.0, 10.0}, config.candidates.neighbour_share);
  config.candidates.min_score = reader.Real("min_score", {0.0, 1.0}, config.candidates.min_score);
  config.consistency.required =
      integer("consistent_keyframes", 1, 100, config.consistency.required);
  config.max_verified = integer("max_verified", 0, 100, config.max_verified);
  config.max_pairs = integer("max_pairs", 0, 1e9, config.max_pairs);
  reader.OptionalMap("nearby", [&](YamlReader& nearby) { ReadNearby(nearby, config.nearby); });
  config.local_map.reach = integer("local_map_reach", 0, 100, config.local_map.reach);
  config.check.verifier.min_inliers =
      integer("min_inliers", 4, 1000, config.check.verifier.min_inliers);
  config.check.relocaliser.min_inliers = config.check.verifier.min_inliers;
  config.step_sigma_factor =
      reader.Real("step_sigma_factor", {1.0, 100.0}, config.step_sigma_factor);
  config.graph.delay_frames = integer("delay_frames", 0, 1000, config.graph.delay_frames);
  config.graph.options.identity_weights =
      reader.Boolean("identity_weights", config.graph.options.identity_weights);
  config.graph.options.check_loops =
      reader.Boolean("check_loops", config.graph.options.check_loops);
  return config;
}

}  // namespace drydock::svin2
