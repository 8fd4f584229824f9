#include "sim/world/ray_scene.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scene.h"

namespace drydock::sim {
namespace {

using testing::BoxElement;
using testing::TemporaryFolder;
using testing::WriteScene;

TEST(RayScene, BoxIsHitWhereItIs) {
  const TemporaryFolder folder;
  const World world(WriteScene(folder.path(), BoxElement("box", {3, 1, 0}, {0.5, 0.5, 0.5}, 45.0)));
  const RayScene rays(world);
  const auto hit = rays.Cast({0, 1, 0}, {1, 0, 0}, 10.0);
  ASSERT_TRUE(hit);
  // The ray meets the edge that points at it, half a diagonal before the centre.
  EXPECT_NEAR(hit->range, 3.0 - 0.5 * std::numbers::sqrt2, 1e-5);
  EXPECT_EQ(world.BodyOfGeom(hit->geom), "box");
  EXPECT_FALSE(rays.Cast({0, 1, 0}, {-1, 0, 0}, 10.0));
  EXPECT_FALSE(rays.Cast({0, 1, 0}, {1, 0, 0}, 2.0));
}

TEST(RayScene, NormalsFaceTheRay) {
  const TemporaryFolder folder;
  const World world(WriteScene(folder.path(), BoxElement("box", {3, 0, 0}, {1, 1, 1})));
  const RayScene rays(world);
  EXPECT_LT((rays.Cast({0, 0.2, 0}, {1, 0, 0}, 10.0)->normal - Eigen::Vector3d(-1, 0, 0)).norm(),
            1e-6);
  // From inside the box its walls are seen as well.
  EXPECT_LT((rays.Cast({3, 0.2, 0}, {1, 0, 0}, 10.0)->normal - Eigen::Vector3d(-1, 0, 0)).norm(),
            1e-6);
}

TEST(RayScene, AFanHitsWhatItsRaysHitAlone) {
  const TemporaryFolder folder;
  const World world(WriteScene(folder.path(), BoxElement("box", {3, 0, 0}, {0.5, 0.4, 0.3}, 20.0) +
                                                  BoxElement("wall", {5, 0, 0}, {0.5, 1, 1})));
  const RayScene rays(world);
  constexpr int kRays = 203;  // Of no packet's width.
  RayFan fan(3, kRays);
  for (int i = 0; i < kRays; ++i) {
    const float angle = 0.003F * static_cast<float>(i - 101);
    fan.col(i) << std::cos(angle), std::sin(angle) * 0.6F, std::sin(angle) * 0.8F;
  }
  const Eigen::Vector3d origin(0.3, 0.1, 0.05);
  const std::vector<FanHit> hits = rays.CastFan(origin, fan, 4.45);
  ASSERT_EQ(hits.size(), 203U);
  int count = 0;
  for (int i = 0; i < kRays; ++i) {
    const Eigen::Vector3d direction = fan.col(i).cast<double>();
    const auto alone = rays.Cast(origin, direction, 4.45);
    const FanHit& hit = hits[static_cast<std::size_t>(i)];
    ASSERT_EQ(hit.geom, alone ? alone->geom : -1) << i;
    if (!alone) continue;
    EXPECT_NEAR(hit.range, alone->range, 1e-5);
    EXPECT_NEAR(hit.cos_incidence, -alone->normal.dot(direction), 1e-5);
    ++count;
  }
  // Some rays pass the box and meet the wall, some pass both.
  EXPECT_GT(count, 100);
  EXPECT_LT(count, kRays);
  EXPECT_TRUE(rays.CastFan(origin, RayFan(3, 0), 4.45).empty());
}

TEST(RayScene, NearestPoint) {
  const TemporaryFolder folder;
  const World world(WriteScene(folder.path(), BoxElement("box", {3, 0, 0}, {1, 1, 1})));
  const RayScene rays(world);
  const auto face = rays.Nearest({0.5, 0.3, -0.2}, 5.0);
  ASSERT_TRUE(face);
  EXPECT_NEAR(face->range, 1.5, 1e-6);
  EXPECT_LT((face->normal - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-6);
  EXPECT_NEAR(rays.Nearest({3.0, 2.0, 2.0}, 5.0)->range, std::numbers::sqrt2, 1e-6);   // Edge.
  EXPECT_NEAR(rays.Nearest({3.0, -2.0, 2.0}, 5.0)->range, std::numbers::sqrt2, 1e-6);  // Edge.
  EXPECT_NEAR(rays.Nearest({5.0, 2.0, 2.0}, 5.0)->range, std::numbers::sqrt3, 1e-6);   // Corner.
  EXPECT_FALSE(rays.Nearest({0.5, 0.3, -0.2}, 1.4));
}

// MuJoCo keeps meshes in a frame of its own: they must come back to where the file has them.
TEST(RayScene, MeshesAreWhereTheFileHasThem) {
  const TemporaryFolder folder;
  WriteFileAtomically(folder.path() / "wedge.obj",
                      "v 1 0 0\nv 3 0 0\nv 1 2 0\nv 1 0 1.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  WriteFileAtomically(
      folder.path() / "scene.xml",
      "<mujoco><asset><mesh name=\"wedge\" file=\"wedge.obj\"/></asset><worldbody>"
      "<body name=\"wedge\" pos=\"0 0 1\"><geom type=\"mesh\" mesh=\"wedge\"/></body>"
      "</worldbody></mujoco>");
  const World world(folder.path() / "scene.xml");
  const RayScene rays(world);
  const auto bottom = rays.Cast({1.5, 0.5, -2.0}, {0, 0, 1}, 10.0);
  ASSERT_TRUE(bottom);
  EXPECT_NEAR(bottom->range, 3.0, 1e-5);
  const auto back = rays.Cast({-1.0, 0.5, 1.2}, {1, 0, 0}, 10.0);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->range, 2.0, 1e-5);
}

TEST(RayScene, UnsupportedShapesAreNamed) {
  const TemporaryFolder folder;
  const World world(WriteScene(
      folder.path(), "<body name=\"pill\"><geom type=\"capsule\" size=\"0.1 0.2\"/></body>"));
  EXPECT_THROW(RayScene{world}, InputError);
}

}  // namespace
}  // namespace drydock::sim
