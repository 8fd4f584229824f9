#include "scenes/mesh/surface_net.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scenes/mesh/cell_noise.h"

namespace drydock::scenes {
namespace {
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Eigen::AlignedBox3d BoxOf(double half) {
  return {Vector3d::Constant(-half), Vector3d::Constant(half)};
}

Mesh NetOf(double half, double cell, const std::function<double(const Vector3d&)>& field) {
  FieldGrid grid(BoxOf(half), cell);
  grid.Fill(field);
  return SurfaceNet(grid);
}

double OffBall(const Vector3d& p) { return p.norm() - 1.0; }

/// Vertices - edges + faces of a closed mesh of triangles, each edge of which two share.
int EulerNumber(const Mesh& mesh) {
  return static_cast<int>(mesh.positions.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

TEST(SurfaceNet, BallIsClosedRoundAndFacesOutwards) {
  const Mesh ball = NetOf(1.3, 0.1, OffBall);
  EXPECT_EQ(CountOpenEdges(ball), 0U);
  EXPECT_EQ(EulerNumber(ball), 2);
  // Chords cut a few per mille off.
  EXPECT_NEAR(EnclosedVolume(ball), 4.0 / 3 * kPi, 0.02 * 4.0 / 3 * kPi);
  EXPECT_NEAR(SurfaceArea(ball), 4 * kPi, 0.02 * 4 * kPi);
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    EXPECT_NEAR(ball.positions[i].norm(), 1.0, 0.02);
    EXPECT_GT(ball.normals[i].dot(ball.positions[i].normalized()), 0.98);
  }
  for (const auto& t : ball.triangles) {
    const Vector3d n = (ball.positions[t[1]] - ball.positions[t[0]])
                           .cross(ball.positions[t[2]] - ball.positions[t[0]]);
    EXPECT_GT(n.dot(ball.positions[t[0]]), 0.0);
  }
}

TEST(SurfaceNet, FinerCellsComeNearer) {
  const auto error = [](double cell) {
    return std::abs(EnclosedVolume(NetOf(1.3, cell, OffBall)) - 4.0 / 3 * kPi);
  };
  EXPECT_LT(error(0.05), 0.35 * error(0.1));
}

TEST(SurfaceNet, AHollowFacesItsInside) {
  const Mesh hollow = NetOf(1.3, 0.1, [](const Vector3d& p) { return -OffBall(p); });
  EXPECT_EQ(CountOpenEdges(hollow), 0U);
  EXPECT_LT(EnclosedVolume(hollow), -4.0);
}

TEST(SurfaceNet, ARingHasItsHole) {
  const Mesh ring = NetOf(1.4, 0.08, [](const Vector3d& p) {
    return std::hypot(p.head<2>().norm() - 0.9, p.z()) - 0.35;
  });
  EXPECT_EQ(CountOpenEdges(ring), 0U);
  EXPECT_EQ(EulerNumber(ring), 0);
  EXPECT_NEAR(EnclosedVolume(ring), 2 * kPi * kPi * 0.9 * 0.35 * 0.35, 0.06);
}

TEST(SurfaceNet, TheLargestPieceIsKept) {
  const auto two = [](const Vector3d& p) {
    return std::min((p - Vector3d(-0.4, 0, 0)).norm() - 0.6,
                    (p - Vector3d(0.8, 0, 0)).norm() - 0.2);
  };
  const Mesh both = NetOf(1.3, 0.05, two);
  const Mesh large = LargestPiece(both);
  EXPECT_EQ(EulerNumber(both), 4);
  EXPECT_EQ(EulerNumber(large), 2);
  EXPECT_EQ(CountOpenEdges(large), 0U);
  EXPECT_NEAR(EnclosedVolume(large), 4.0 / 3 * kPi * 0.216, 0.03);
  for (const Vector3d& p : large.positions) EXPECT_LT(p.x(), 0.3);
}

TEST(FieldGrid, CoversItsBox) {
  const FieldGrid grid({Vector3d(0.0, 1.0, 2.0), Vector3d(1.0, 1.55, 2.3)}, 0.1);
  EXPECT_EQ(grid.counts(), (std::array<int, 3>{11, 7, 4}));
  EXPECT_TRUE(grid.PointAt(10, 6, 3).isApprox(Vector3d(1.0, 1.6, 2.3)));
}

TEST(CellNoise, FindsTheNearestPoint) {
  // No nearer than any point found from somewhere else, and never farther than a cell's diagonal.
  double largest = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d p(0.013 * i, -0.007 * i, 0.021 * i);
    const StrewnPoint here = NearestStrewn(p, 3);
    EXPECT_EQ(here.bits, NearestStrewn(p, 3).bits);
    const StrewnPoint beside = NearestStrewn(p + Vector3d(0.01, 0, 0), 3);
    EXPECT_LT(std::abs(beside.distance - here.distance), 0.0101) << i;
    largest = std::max(largest, here.distance);
  }
  EXPECT_GT(largest, 0.6);
  EXPECT_LT(largest, 1.5);
}

}  // namespace
}  // namespace drydock::scenes
