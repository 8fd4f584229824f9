#include "sim/world/path_clearance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sim/motion/spline_motion.h"
#include "tests/support/input_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using drydock::testing::InputErrorOf;

MotionConfig Straight() {
  MotionConfig config;
  for (const double x : {0.0, 2.0, 4.0, 6.0}) {
    Waypoint waypoint;
    waypoint.position = {x, 0.0, 0.0};
    config.waypoints.push_back(waypoint);
  }
  return config;
}

TEST(PathClearance, PassesBesideButNotThrough) {
  const testing::TemporaryFolder folder;
  const World world(testing::WriteScene(
      folder.path(), testing::BoxElement("post", {3.0, 0.6, 0.0}, {0.1, 0.1, 1.0})));
  const RayScene rays(world);
  const SplineMotion motion(Straight(), 1);
  EXPECT_NO_THROW(RequireClearPath(motion, world, rays, 0.45));
  const std::string error = InputErrorOf([&] { RequireClearPath(motion, world, rays, 0.55); });
  EXPECT_THAT(error, ::testing::StartsWith("motion: at "));
  EXPECT_THAT(error, ::testing::HasSubstr("'post'"));
  const auto place = [&](Time t) {
    return "way-point " + std::to_string(motion.NearestWaypoint(t));
  };
  const std::string with_place =
      InputErrorOf([&] { RequireClearPath(motion, world, rays, 0.55, place); });
  // The post is at x = 3; it is met a bit before, nearest to the second way-point at 2.
  EXPECT_THAT(with_place, ::testing::StartsWith("way-point 1: at "));
}

}  // namespace
}  // namespace drydock::sim
