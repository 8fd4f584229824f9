#include "scenarios/scoring/maps.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace drydock::score {
namespace {

/// A flat bed at z = 0 that is felt up to 1 m.
std::optional<double> ToTheBed(const Eigen::Vector3d& point) {
  const double distance = std::abs(point.z());
  return distance < kFarthestMapPoint ? std::optional(distance) : std::nullopt;
}

TEST(MapRmse, IsTheRootMeanSquareOfTheDistances) {
  const std::vector<Eigen::Vector3d> points = {{5.0, 1.0, 0.3}, {-2.0, 7.0, -0.4}};
  EXPECT_NEAR(*MapRmse(points, {}, ToTheBed), std::sqrt((0.09 + 0.16) / 2.0), 1e-12);
}

TEST(MapRmse, IsTakenWhereTheMapIsLaidUponTheTruth) {
  // The estimator's world stands on its side, 2 m below.
  const Similarity alignment{
      1.0, Pose(FromYawPitchRoll(0.0, 0.0, std::numbers::pi / 2), {0.0, 0.0, -2.0})};
  EXPECT_NEAR(*MapRmse({{3.0, 2.1, 8.0}}, alignment, ToTheBed), 0.1, 1e-12);
}

TEST(MapRmse, AWildPointCountsAsAMetre) {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  for (const double z : {1.0, 50.0, no_number}) {
    EXPECT_NEAR(*MapRmse({{0, 0, 0}, {0, 0, z}, {1, 0, 0}, {2, 0, 0}}, {}, ToTheBed), 0.5, 1e-12);
  }
  const auto far = [](const Eigen::Vector3d&) { return std::optional(30.0); };
  EXPECT_EQ(MapRmse({{0, 0, 0}}, {}, far), 1.0);
}

TEST(MapRmse, IsNothingOfNoPoints) { EXPECT_FALSE(MapRmse({}, {}, ToTheBed)); }

}  // namespace
}  // namespace drydock::score
