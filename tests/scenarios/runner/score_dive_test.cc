#include "scenarios/runner/score_dive.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenarios/runner/dive.h"
#include "sensors_models/base/resources.h"

namespace drydock {
namespace {

/// Where rays from the dive's start meet the scene [m, in W].
std::vector<Eigen::Vector3d> PointsOfTheScene(const Dive& dive) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d way(std::cos(0.1 * i), std::sin(0.1 * i), -0.4);
    if (const auto hit = dive.rays().Cast(Eigen::Vector3d::Zero(), way.normalized(), 8.0))
      points.push_back(hit->range * way.normalized());
  }
  return points;
}

TEST(ScoreDive, HoldsTheMapAgainstTheScene) {
  const Scenario scenario = LoadScenario(DataDirectory() / "scenarios" / "bus.yaml",
                                         {"sensors={stereo: {enabled: false}}", "duration_s=12"});
  const Dive dive(scenario, sim::RendererBackend::kAuto);
  const Trajectory truth = dive.Truth();
  // The estimator's world is another; it sees the surfaces exactly, and the sonar sees some that
  // are not there.
  const Pose T_estimate_truth(FromYawPitchRoll(1.2, 0.1, -0.2), {7.0, -3.0, 2.0});
  Results results;
  for (const StampedPose& pose : truth)
    results.odometry.push_back({pose.t, T_estimate_truth * pose.T_WI});
  results.corrected = results.odometry;
  for (const Eigen::Vector3d& point : PointsOfTheScene(dive))
    results.map.landmarks.push_back(T_estimate_truth * point);
  ASSERT_GT(results.map.landmarks.size(), 30U);
  EXPECT_FALSE(ScoreDive(scenario, dive, truth, results).metrics.sonar_map_rmse_m);
  results.map.sonar = {T_estimate_truth * Eigen::Vector3d(0.0, 0.0, 4.0)};
  const score::Metrics metrics = ScoreDive(scenario, dive, truth, results).metrics;
  EXPECT_LT(*metrics.landmark_map_rmse_m, 1e-4);
  EXPECT_EQ(*metrics.sonar_map_rmse_m, 1.0);
  EXPECT_EQ(*metrics.loops_found, 0.0);
}

}  // namespace
}  // namespace drydock
