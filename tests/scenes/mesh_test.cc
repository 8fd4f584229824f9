#include "scenes/mesh/mesh.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/msh_file.h"
#include "scenes/mesh/shapes.h"
#include "scenes/mesh/slab.h"
#include "sensors_models/base/files.h"

namespace drydock::scenes {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Whether every vertex normal agrees with the triangles around it.
void ExpectNormalsFollowTriangles(const Mesh& mesh) {
  for (const auto& t : mesh.triangles) {
    const Vector3d n = (mesh.positions[t[1]] - mesh.positions[t[0]])
                           .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (const int i : t) {
      EXPECT_GT(n.dot(mesh.normals[i]), 0.0);
      EXPECT_NEAR(mesh.normals[i].norm(), 1.0, 1e-9);
    }
  }
}

TEST(Mesh, BoxIsClosedAndFacesOutwards) {
  const Mesh box = Box({1, 2, 3}, {0.5, 0.6, 0.7}, {});
  EXPECT_EQ(box.triangles.size(), 12U);
  EXPECT_EQ(CountOpenEdges(box), 0U);
  EXPECT_NEAR(EnclosedVolume(box), 0.5 * 0.6 * 0.7, 1e-12);
  EXPECT_NEAR(SurfaceArea(box), 2 * (0.5 * 0.6 + 0.5 * 0.7 + 0.6 * 0.7), 1e-12);
  ExpectNormalsFollowTriangles(box);
}

TEST(Mesh, EraseDropsWhatIsWhollyUnwanted) {
  // The lid has two triangles, the sides two each with a corner below; the bottom's two go, with
  // the four vertices of their own.
  Mesh box = Box(Vector3d::Zero(), {1, 1, 1}, {}, 0.0, 2);
  ASSERT_EQ(box.positions.size(), 24U);
  const double area = SurfaceArea(box);
  box.Erase([](const Vector3d& p) { return p.z() < 0; });
  EXPECT_EQ(box.triangles.size(), 10U);
  EXPECT_EQ(box.positions.size(), 20U);
  EXPECT_NEAR(SurfaceArea(box), area - 1.0, 1e-12);
  ExpectNormalsFollowTriangles(box);
  box.Erase([](const Vector3d&) { return true; });
  EXPECT_TRUE(box.IsEmpty());
  EXPECT_TRUE(box.positions.empty());
}

TEST(Mesh, BevelledBoxIsClosed) {
  for (int axis = 0; axis < 3; ++axis) {
    const Mesh box = Box(Vector3d::Zero(), {0.4, 0.3, 0.2}, {}, 0.05, axis);
    EXPECT_EQ(CountOpenEdges(box), 0U);
    EXPECT_LT(EnclosedVolume(box), 0.4 * 0.3 * 0.2);
    EXPECT_GT(EnclosedVolume(box), 0.9 * 0.4 * 0.3 * 0.2);
    ExpectNormalsFollowTriangles(box);
  }
}

TEST(Mesh, BoxTextureKeepsItsScale) {
  const Mesh box = Box(Vector3d::Zero(), {1, 2, 3}, {0.5, {0.1, 0.2}});
  for (const auto& t : box.triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = t[i];
      const int b = t[(i + 1) % 3];
      const double metres = (box.positions[a] - box.positions[b]).norm();
      EXPECT_NEAR((box.uvs[a] - box.uvs[b]).norm(), metres / 0.5, 1e-9);
    }
  }
}

TEST(Mesh, TubeIsClosed) {
  const Mesh tube = Tube({{0, 0, 0}, {0, 0, 1}, {0.3, 0, 2}}, 0.1, 24, {});
  EXPECT_EQ(CountOpenEdges(tube), 0U);
  EXPECT_EQ(tube.triangles.size(), 2U * 2 * 24 + 2 * 24);
  EXPECT_NEAR(EnclosedVolume(tube), std::numbers::pi * 0.01 * (1 + std::hypot(0.3, 1.0)), 0.004);
  ExpectNormalsFollowTriangles(tube);
}

TEST(Mesh, TurnedBallIsClosedAndHasNoEmptyTriangles) {
  std::vector<Vector2d> profile;
  for (int i = 0; i <= 20; ++i) {
    const double angle = std::numbers::pi * (i / 20.0 - 0.5);
    profile.emplace_back(i % 20 == 0 ? 0.0 : std::cos(angle), std::sin(angle));
  }
  const Mesh ball = Lathe(profile, 40);
  EXPECT_EQ(CountOpenEdges(ball), 0U);
  EXPECT_NEAR(EnclosedVolume(ball), 4.0 / 3 * std::numbers::pi, 0.06);
  EXPECT_EQ(ball.triangles.size(), 40U * (2 * 20 - 2));
}

TEST(Mesh, RockIsClosedAndTheSameForTheSameKey) {
  const Mesh rock = Rock({1.0, 0.8, 0.6}, 4, 0.3, 7, {});
  EXPECT_EQ(rock.triangles.size(), 6U * 4 * 4 * 2);
  EXPECT_EQ(CountOpenEdges(rock), 0U);
  EXPECT_GT(EnclosedVolume(rock), 0.05);
  EXPECT_EQ(rock.positions, Rock({1.0, 0.8, 0.6}, 4, 0.3, 7, {}).positions);
  EXPECT_NE(rock.positions, Rock({1.0, 0.8, 0.6}, 4, 0.3, 8, {}).positions);
}

TEST(Mesh, LeavesAreSeenFromBothSides) {
  const Mesh leaf = Ribbon({{0, 0, 0}, {0, 0, 1}}, {0.1, 0.05}, Vector3d::UnitX(), {});
  EXPECT_EQ(leaf.triangles.size(), 4U);
  EXPECT_NEAR(SurfaceArea(leaf), 2 * 0.15, 1e-12);
  EXPECT_NEAR(EnclosedVolume(leaf), 0.0, 1e-12);
  EXPECT_EQ(CountOpenEdges(leaf), 0U);
}

TEST(Mesh, MirrorKeepsTheOutsideOut) {
  Mesh box = Box({0, 1, 0}, {1, 1, 1}, {});
  box.MirrorY();
  EXPECT_NEAR(EnclosedVolume(box), 1.0, 1e-12);
  ExpectNormalsFollowTriangles(box);
}

SlabPlan FlatWall() {
  SlabPlan plan;
  plan.u_lines = {0, 1, 2, 3};
  plan.v_lines = {0, 1, 2, 3};
  plan.is_hole = [](int i, int j) { return i == 1 && j == 1; };
  plan.outer = [](double u, double v) -> Vector3d { return {u, v, 0.0}; };
  plan.inner = [](double u, double v) -> Vector3d { return {u, v, -0.1}; };
  plan.outer_uv = [](const Vector3d& p) -> Vector2d { return {p.x() / 3, p.y() / 3}; };
  plan.inner_uv = plan.outer_uv;
  return plan;
}

TEST(Slab, WallWithAWindowIsClosed) {
  SlabMeshes meshes = BuildSlab(FlatWall());
  Mesh all = meshes.outer;
  all.Append(meshes.inner);
  EXPECT_EQ(CountOpenEdges(all), 0U);
  EXPECT_NEAR(EnclosedVolume(all), (9 - 1) * 0.1, 1e-12);
  EXPECT_NEAR(SurfaceArea(all), 2 * 8 + (12 + 4) * 0.1, 1e-12);
  ExpectNormalsFollowTriangles(all);
}

TEST(Slab, PiecesMakeUpTheWhole) {
  const SlabPlan plan = FlatWall();
  Mesh all;
  for (int i = 0; i < 3; ++i) {
    const SlabMeshes piece = BuildSlab(plan, i, i + 1);
    all.Append(piece.outer);
    all.Append(piece.inner);
  }
  EXPECT_EQ(CountOpenEdges(all), 0U);
  EXPECT_NEAR(EnclosedVolume(all), 0.8, 1e-12);
}

TEST(Slab, StepsDivideGaps) {
  EXPECT_EQ(WithSteps({2.0, 0.0, 0.0, 1.0}, 0.5), (std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0}));
}

TEST(LatticeNoise, IsSmoothAndBounded) {
  double low = 1.0;
  double high = -1.0;
  for (int i = 0; i < 4000; ++i) {
    const Vector2d p(0.013 * i, 0.007 * i);
    const double value = Noise2(p, 5);
    low = std::min(low, value);
    high = std::max(high, value);
    EXPECT_LT(std::abs(Noise2(p + Vector2d(1e-4, 0), 5) - value), 2e-3);
  }
  EXPECT_GE(low, -1.0);
  EXPECT_LE(high, 1.0);
  EXPECT_GT(high - low, 1.0);
}

TEST(MshFile, HasTheCountsAndTheValues) {
  const auto path = std::filesystem::path(testing::TempDir()) / "box.msh";
  const Mesh box = Box(Vector3d::Zero(), {1, 1, 1}, {});
  WriteMsh(box, path);
  const std::string bytes = ReadFile(path);
  std::int32_t counts[4];
  ASSERT_GE(bytes.size(), sizeof counts);
  std::memcpy(counts, bytes.data(), sizeof counts);
  const auto vertices = static_cast<std::int32_t>(box.positions.size());
  EXPECT_EQ(counts[0], vertices);
  EXPECT_EQ(counts[1], vertices);
  EXPECT_EQ(counts[2], vertices);
  EXPECT_EQ(counts[3], 12);
  EXPECT_EQ(bytes.size(), 16U + vertices * 8U * 4U + 12U * 12U);
  float x = 0;
  std::memcpy(&x, bytes.data() + 16, sizeof x);
  EXPECT_EQ(x, static_cast<float>(box.positions[0].x()));
}

}  // namespace
}  // namespace drydock::scenes
