#include "scenarios/scoring/initialisation.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/scenarios/scoring/support.h"

namespace drydock::score {
namespace {

/// Rests for 2 s, then swims a winding line at 0.5 m/s: 5 cm are passed at 2.1 s.
Eigen::Vector3d Swim(double t) {
  const double s = std::max(0.0, t - 2.0);
  return {0.5 * s, 0.2 * std::sin(s), 0.0};
}

/// The estimate is `scale` times too large until `until` seconds, then twice as large.
Trajectory Scaled(double scale, double until) {
  return MakeTrajectory(201, 0.1, [=](double t) {
    return Eigen::Vector3d((t <= until ? scale : 2.0) * Swim(t) + Eigen::Vector3d(4.0, 0.0, 1.0));
  });
}

const Trajectory kTruth = MakeTrajectory(201, 0.1, Swim);

TEST(InitialScaleError, IsThatOfTheFirstFiveSecondsOfMotion) {
  // 5 cm along the line are passed by the pose of 2.1 s: the span ends at 7.1 s.
  EXPECT_NEAR(*InitialScaleErrorPercent(kTruth, Scaled(1.03, 7.15)), 3.0, 1e-6);
  EXPECT_NEAR(*InitialScaleErrorPercent(kTruth, Scaled(0.96, 7.15)), -4.0, 1e-6);
  EXPECT_GT(*InitialScaleErrorPercent(kTruth, Scaled(1.03, 7.05)), 3.1)
      << "the last pose of the span counts";
}

TEST(InitialScaleError, NeedsMotion) {
  Trajectory until_6_s = Scaled(1.0, 20.0);
  until_6_s.resize(61);
  EXPECT_FALSE(InitialScaleErrorPercent(kTruth, until_6_s)) << "only 4 s of motion";
  EXPECT_FALSE(InitialScaleErrorPercent(kTruth, {}));
  const Trajectory slow = MakeTrajectory(201, 0.1, [](double t) {
    return Eigen::Vector3d(0.05 * t, 0.01 * std::sin(t), 0.0);  // 0.25 m in 5 s.
  });
  EXPECT_FALSE(InitialScaleErrorPercent(slow, slow));
  const Trajectory rest =
      MakeTrajectory(201, 0.1, [](double) { return Eigen::Vector3d(0.0, 0.0, 0.0); });
  EXPECT_FALSE(InitialScaleErrorPercent(rest, rest));
}

}  // namespace
}  // namespace drydock::score
