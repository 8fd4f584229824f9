#include "scenes/mesh/plate.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace drydock::scenes {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

Mesh Plate(const Outline& outline, double thickness, double bevel) {
  const Outline faces = bevel > 0.0 ? Inset(outline, bevel) : outline;
  Mesh plate = PlateRim(outline, thickness, {}, bevel);
  for (const double side : {-0.5, 0.5}) {
    plate.Append(PlateFace(faces, {0.0, 0.5}, side * thickness,
                           [](const Vector2d& p) -> Vector2d { return p; }));
  }
  return plate;
}

TEST(Plate, IsClosedWithItsOutsideOut) {
  const Outline outline = RoundTopOutline(0.3, 0.1, 0.7, 0.2, 40);
  const Mesh plate = Plate(outline, 0.1, 0.0);
  EXPECT_EQ(CountOpenEdges(plate), 0U);
  // A rectangle and half an ellipse.
  const double area = 0.6 * 0.6 + 0.5 * std::numbers::pi * 0.3 * 0.2;
  EXPECT_NEAR(EnclosedVolume(plate), 0.1 * area, 1e-4);
}

TEST(Plate, BevelCutsItsEdges) {
  const Outline square = {{-0.5, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {-0.5, 1.0}};
  const double bevel = 0.1;
  const Mesh plate = Plate(square, 0.4, bevel);
  EXPECT_EQ(CountOpenEdges(plate), 0U);
  // Two frustums of height 0.1 between squares of 0.8 and 1, and a slab of 0.2 between them.
  const double frustum = bevel / 3.0 * (0.64 + 1.0 + 0.8);
  EXPECT_NEAR(EnclosedVolume(plate), 2.0 * frustum + 0.2, 1e-12);
}

TEST(Plate, InsetStaysAwayFromEveryEdge) {
  // A cross: also where corners are re-entrant.
  const Outline cross = {{-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1},   {1, 1},
                         {1, 3},   {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}};
  const Outline inset = Inset(cross, 0.25);
  ASSERT_EQ(inset.size(), cross.size());
  EXPECT_LT((inset[0] - Vector2d(-0.75, -2.75)).norm(), 1e-12);
  EXPECT_LT((inset[2] - Vector2d(0.75, -0.75)).norm(), 1e-12);
}

TEST(Plate, ClipBreaksACornerOff) {
  const Outline square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Outline clipped = Clip(square, {1.0, 0.5}, {1.0, 1.0});
  ASSERT_EQ(clipped.size(), 5U);
  for (const Vector2d& p : clipped) EXPECT_LE(p.sum(), 1.5 + 1e-12);
  EXPECT_EQ(Clip(square, {2.0, 2.0}, {1.0, 1.0}).size(), 4U);
}

TEST(GroundTile, NeighboursMeet) {
  const auto height = [](const Vector2d& p) { return std::sin(p.x()) + 0.3 * p.y(); };
  const auto uv = [](const Vector2d& p) -> Vector2d { return p / 2.0; };
  Mesh tiles = GroundTile({1.0, 2.0}, 3.0, 4, height, uv);
  const Mesh next = GroundTile({4.0, 2.0}, 3.0, 4, height, uv);
  const std::size_t open = CountOpenEdges(tiles) + CountOpenEdges(next);
  EXPECT_EQ(open, 32U);
  tiles.Append(next);
  EXPECT_EQ(CountOpenEdges(tiles), 24U);
  for (std::size_t i = 0; i < tiles.positions.size(); ++i) {
    const Vector3d& p = tiles.positions[i];
    EXPECT_DOUBLE_EQ(p.z(), height(p.head<2>()));
    EXPECT_EQ(tiles.uvs[i], uv(p.head<2>()));
    EXPECT_GT(tiles.normals[i].z(), 0.0);
  }
}

TEST(Wear, MovesSurfacesByItsDepthAndKeepsThemClosed) {
  const Mesh whole = Box({0.4, 0.2, 0.1}, {1.0, 0.8, 0.6}, {}, 0.1, 2);
  Mesh worn = whole;
  Wear(worn, 0.2, 0.02, 5);
  EXPECT_EQ(CountOpenEdges(worn), 0U);
  double largest = 0.0;
  for (std::size_t i = 0; i < whole.positions.size(); ++i) {
    largest = std::max(largest, (worn.positions[i] - whole.positions[i]).norm());
  }
  EXPECT_GT(largest, 0.002);
  EXPECT_LT(largest, 0.04);
}

}  // namespace
}  // namespace drydock::scenes
