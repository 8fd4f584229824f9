#include "sim/optics/daylight_grid.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using testing::BoxElement;

/// A roof of 6 m x 6 m, 2 m above the ground at the origin, and a tall long wall at y = 20.
class DaylightGridTest : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  World world_{
      testing::WriteScene(folder_.path(), BoxElement("roof", {0, 0, 2.05}, {3, 3, 0.05}) +
                                              BoxElement("wall", {0, 20.5, 15}, {25, 0.5, 15}) +
                                              BoxElement("stone", {0, -20, 0.1}, {0.1, 0.1, 0.1}))};
  RayScene rays_{world_};
  const Eigen::Vector3d sun_ = Eigen::Vector3d(0.0, -1.0, 1.0).normalized();
};

TEST_F(DaylightGridTest, OpenWaterGetsAllOfIt) {
  DaylightGrid grid(rays_, sun_);
  const Daylight above = grid.At({0, 0, 3});
  EXPECT_EQ(above.sun, 1.F);
  const Daylight open = grid.At({0, -15, 1});
  EXPECT_EQ(open.sun, 1.F);
  EXPECT_GT(open.sky, 0.98F);
}

TEST_F(DaylightGridTest, ARoofKeepsTheSunOff) {
  DaylightGrid grid(rays_, sun_);
  // The sun stands at 45 degrees towards -y: on the ground the shadow lies 2 m towards +y.
  EXPECT_EQ(grid.At({0, 2, 0}).sun, 0.F);
  EXPECT_EQ(grid.At({0, 4, 0}).sun, 0.F);
  EXPECT_EQ(grid.At({0, 6, 0}).sun, 1.F);
  EXPECT_EQ(grid.At({0, -2, 0}).sun, 1.F);
  EXPECT_LT(grid.At({0, 0, 1.5}).sky, 0.2F);
}

// Close to a wall that reaches far and high, half of the sky is left.
TEST_F(DaylightGridTest, AWallHidesHalfTheSky) {
  DaylightGrid grid(rays_, sun_);
  EXPECT_NEAR(grid.At({0, 19.7F, 0.5}).sky, 0.5, 0.06);
}

TEST_F(DaylightGridTest, DoesNotDependOnTheOrderOfAsking) {
  DaylightGrid forth(rays_, sun_), back(rays_, sun_);
  std::vector<Eigen::Vector3f> places;
  for (int i = 0; i < 200; ++i) {
    const auto x = static_cast<float>(i);
    places.emplace_back(0.1F * x - 10.F, 0.19F * x - 15.F, 0.02F * x);
  }
  std::vector<Daylight> light;
  light.reserve(places.size());
  for (const auto& place : places) light.push_back(forth.At(place));
  for (std::size_t i = places.size(); i-- > 0;) {
    const Daylight again = back.At(places[i]);
    EXPECT_EQ(again.sun, light[i].sun);
    EXPECT_EQ(again.sky, light[i].sky);
  }
}

TEST_F(DaylightGridTest, PlacesOutsideAreAsTheNearestInside) {
  DaylightGrid grid(rays_, sun_);
  EXPECT_EQ(grid.At({0, -500, 1}).sun, 1.F);
  EXPECT_EQ(grid.At({0, 0, 1e6F}).sky, 1.F);
  EXPECT_NO_THROW(grid.At({std::numeric_limits<float>::quiet_NaN(), 0, 0}));
}

TEST(DaylightGrid, AnEmptySceneHasNoShadows) {
  const testing::TemporaryFolder folder;
  const World world(testing::WriteScene(folder.path(), "<geom type='plane' size='0 0 1'/>"));
  const RayScene rays(world);
  DaylightGrid grid(rays, {0, 0, 1});
  EXPECT_EQ(grid.At({1, 2, 3}).sun, 1.F);
  EXPECT_EQ(grid.At({1, 2, 3}).sky, 1.F);
}

}  // namespace
}  // namespace drydock::sim
