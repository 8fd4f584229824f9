#include "estimator/svin2/sonar/sonar_patch.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace drydock::svin2 {
namespace {

using Eigen::Vector3d;

/// A wall at x = 2 + y tan(slope), with landmarks on a grid of 5 cm about y = `centre`.
std::vector<PatchCandidate> Wall(double slope, double centre = 0.0) {
  std::vector<PatchCandidate> wall;
  for (const double dy : {-0.05, 0.0, 0.05}) {
    for (const double z : {-0.05, 0.0, 0.05}) {
      const double y = centre + dy;
      wall.push_back({{2.0 + y * std::tan(slope), y, z}, std::nullopt});
    }
  }
  return wall;
}

constexpr double kRange = 2.0;
const PingRay kAhead{Vector3d::Zero(), Vector3d::UnitX(), kRange};

TEST(SonarPatch, OnAWallMetSquarelyTheMeanIsTheEcho) {
  SonarPatchConfig config;
  config.max_landmarks = 9;
  const auto patch = FindSonarPatch(kAhead, Wall(0.0), config);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->members.size(), 9U);
  EXPECT_NEAR(patch->range_correction, 0.0, 1e-12);
  EXPECT_NEAR(patch->innovation, 0.0, 1e-12);
  EXPECT_NEAR(patch->sigma, config.surface_sigma_m, 1e-12);
}

TEST(SonarPatch, CorrectsForAMeanBesideTheBeam) {
  // Landmarks about y = 0.1 on a wall that runs away at 45 degrees: their mean is at (2.1, 0.1, 0),
  // 2.102 m from the head, while the beam meets the wall at 2 m.
  SonarPatchConfig config;
  config.max_landmarks = 9;
  config.radius_m = 0.3;
  const auto patch = FindSonarPatch(kAhead, Wall(std::atan(1.0), 0.1), config);
  ASSERT_TRUE(patch.has_value());
  ASSERT_EQ(patch->members.size(), 9U);
  EXPECT_NEAR(patch->range_correction, std::hypot(2.1, 0.1) - 2.0, 1e-12);
  EXPECT_NEAR(patch->innovation, 0.0, 1e-12);
  EXPECT_NEAR(patch->sigma, config.surface_sigma_m * std::sqrt(2.0), 1e-12);
}

TEST(SonarPatch, SaysHowFarThePingIsOff) {
  PingRay ping = kAhead;
  ping.range = 2.06;
  const auto patch = FindSonarPatch(ping, Wall(0.0), {});
  ASSERT_TRUE(patch.has_value());
  EXPECT_NEAR(patch->innovation, 0.06, 1e-12);
}

TEST(SonarPatch, TakesTheNearest) {
  SonarPatchConfig config;
  config.max_landmarks = 5;
  const auto patch = FindSonarPatch(kAhead, Wall(0.0), config);
  ASSERT_TRUE(patch.has_value());
  ASSERT_EQ(patch->members.size(), 5U);
  EXPECT_EQ(patch->members[0].p_W, Vector3d(2, 0, 0));
  for (const PatchCandidate& member : patch->members)
    EXPECT_LE((member.p_W - Vector3d(2, 0, 0)).norm(), 0.05 + 1e-12);
}

TEST(SonarPatch, NothingWhereLandmarksAreTooFewOrFar) {
  std::vector<PatchCandidate> wall = Wall(0.0);
  EXPECT_FALSE(FindSonarPatch(kAhead, Wall(0.0, 1.0), {}).has_value());
  wall.resize(3);
  EXPECT_FALSE(FindSonarPatch(kAhead, wall, {}).has_value());
  EXPECT_FALSE(FindSonarPatch(kAhead, {}, {}).has_value());
}

TEST(SonarPatch, NothingOnALineOrRubbleOrAtAGrazingAngle) {
  std::vector<PatchCandidate> line, rubble;
  for (const double z : {-0.1, -0.05, 0.0, 0.05, 0.1}) line.push_back({{2, 0, z}, std::nullopt});
  for (const auto& [dx, y, z] : {std::tuple{0.12, 0.1, 0.1},
                                 {-0.12, -0.1, 0.1},
                                 {0.12, -0.1, -0.1},
                                 {-0.12, 0.1, -0.1},
                                 {0.1, 0.0, 0.0}})
    rubble.push_back({{2.0 + dx, y, z}, std::nullopt});
  SonarPatchConfig config;
  config.radius_m = 0.5;
  EXPECT_FALSE(FindSonarPatch(kAhead, line, config).has_value());
  EXPECT_FALSE(FindSonarPatch(kAhead, rubble, config).has_value());
  EXPECT_TRUE(FindSonarPatch(kAhead, Wall(1.0), config).has_value());   // cos 57 deg = 0.54
  EXPECT_FALSE(FindSonarPatch(kAhead, Wall(1.1), config).has_value());  // cos 63 deg = 0.45
}

}  // namespace
}  // namespace drydock::svin2
