#include "sim/sensors/sonar.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/models/sonar_model.h"
#include "tests/sim/sensors/still_motion.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

SonarSheet Sheet() {
  SonarSheet sheet;
  sheet.rate_hz = 100.0;
  sheet.T_IS = Pose(Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.1, 0.0, 0.2});  // Scans y-z of I.
  sheet.step_rad = std::numbers::pi / 180.0;
  sheet.min_range_m = 0.125;
  sheet.max_range_m = 6.0;
  sheet.range_noise_m = 0.01;
  return sheet;
}

/// A wall whose face is the plane y = 2.
std::string Wall() { return testing::BoxElement("wall", {0.0, 3.0, 0.0}, {20.0, 1.0, 20.0}); }

TEST(Sonar, RangesOfAWallAreExact) {
  const testing::TemporaryFolder folder;
  const World world(testing::WriteScene(folder.path(), Wall()));
  const RayScene rays(world);
  const StillMotion motion(Pose(Eigen::Quaterniond::Identity(), {1.0, 0.5, -0.3}));
  Sonar sonar(motion, world, rays, Sheet(), false, {}, 1);
  int hits = 0;
  for (int k = 0; k < 360; ++k) {
    const Observation observation = sonar.Observe();
    const auto& ping = std::get<SonarPing>(observation.measurement.reading);
    const auto& truth = std::get<SonarTruth>(observation.truth);
    EXPECT_EQ(ping.range, truth.range);
    EXPECT_EQ(ping.first_range, truth.range);
    EXPECT_TRUE(ping.profile.empty());
    const double toward = std::cos(ping.head_angle);  // The beam's share along y.
    const double expected = toward > 0.0 ? 1.5 / toward : 1e9;
    if (expected > 6.0) {
      EXPECT_EQ(ping.range, 0.0);
      EXPECT_EQ(truth.body, "");
    } else {
      EXPECT_NEAR(ping.range, expected, 1e-5);
      EXPECT_NEAR(ping.intensity, toward, 1e-5);
      EXPECT_EQ(truth.body, "wall");
      ++hits;
    }
  }
  EXPECT_EQ(hits, 151);  // Beams within acos(1.5 / 6) of the wall's normal.
}

TEST(Sonar, NoiseHasItsSize) {
  const testing::TemporaryFolder folder;
  const World world(testing::WriteScene(folder.path(), Wall()));
  const RayScene rays(world);
  const StillMotion motion(Pose::Identity());
  Sonar sonar(motion, world, rays, Sheet(), true, {}, 1);
  double squares = 0.0;
  int count = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Observation observation = sonar.Observe();
    const double error = std::get<SonarPing>(observation.measurement.reading).range -
                         std::get<SonarTruth>(observation.truth).range;
    if (error == 0.0) continue;
    squares += error * error;
    ++count;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 0.0005);
}

}  // namespace
}  // namespace drydock::sim
