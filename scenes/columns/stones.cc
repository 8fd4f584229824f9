#include "scenes/columns/stones.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::columns {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStonePeriod = 1.7;  // [m], of the texture
constexpr std::uint64_t kWear = 11;   // Of shapes alone: the same wear on every copy of any seed.

/// Wear of some millimetres. A function of the place, so that what was closed stays so.
void Wear(Mesh& mesh) {
  for (Vector3d& p : mesh.positions) {
    const Vector3d q = p / 0.22;
    p += 0.014 * Vector3d(Fbm3(q, 2, kWear), Fbm3(q, 2, kWear + 1), Fbm3(q, 2, kWear + 2));
  }
  mesh.ComputeSmoothNormals();
}

Mesh Block(double z_low, const Vector3d& size, const Vector2d& shift) {
  return Box({0.0, 0.0, z_low + 0.5 * size.z()}, size, {kStonePeriod, shift}, 0.03, 2);
}

constexpr double kSlabHalf = 0.38;       // [m]
constexpr double kSlabThickness = 0.20;  // [m]
constexpr double kSlabFoot = 0.16;       // [m]
constexpr double kSlabShoulder = 1.10;   // [m]
constexpr double kSlabTop = kSlabShoulder + kSlabHalf;

/// The slab's outline in x and z, counter-clockwise seen against y.
std::vector<Vector2d> SlabOutline() {
  constexpr int kArc = 14;
  std::vector<Vector2d> outline = {{-kSlabHalf, kSlabFoot}, {kSlabHalf, kSlabFoot}};
  for (int i = 0; i <= kArc; ++i) {
    const double angle = std::numbers::pi * i / kArc;
    outline.emplace_back(kSlabHalf * std::cos(angle), kSlabShoulder + kSlabHalf * std::sin(angle));
  }
  return outline;
}

/// One face of the slab; both show the picture upright.
Mesh SlabFace(const std::vector<Vector2d>& outline, bool front) {
  const double side = front ? -1.0 : 1.0;
  Mesh face;
  const auto add = [&](const Vector2d& p) {
    const Vector2d uv(0.5 - side * 0.5 * p.x() / kSlabHalf,
                      (kSlabTop - p.y()) / (kSlabTop - kSlabFoot));
    return face.AddVertex({p.x(), 0.5 * side * kSlabThickness, p.y()}, side * Vector3d::UnitY(),
                          uv);
  };
  const int middle = add({0.0, 0.7});
  for (const Vector2d& p : outline) add(p);
  const int count = static_cast<int>(outline.size());
  for (int i = 0; i < count; ++i) {
    const int a = 1 + i;
    const int b = 1 + (i + 1) % count;
    face.AddTriangle(middle, front ? a : b, front ? b : a);
  }
  return face;
}

Mesh SlabRim(const std::vector<Vector2d>& outline) {
  const double half = 0.5 * kSlabThickness;
  Mesh rim;
  double along = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& p = outline[i];
    const Vector2d& q = outline[(i + 1) % outline.size()];
    const double next = along + (q - p).norm();
    const double u = kSlabThickness / kStonePeriod;
    rim.AddQuad({Vector3d(p.x(), -half, p.y()), Vector3d(p.x(), half, p.y()),
                 Vector3d(q.x(), half, q.y()), Vector3d(q.x(), -half, q.y())},
                {Vector2d(0.0, along / kStonePeriod), Vector2d(u, along / kStonePeriod),
                 Vector2d(u, next / kStonePeriod), Vector2d(0.0, next / kStonePeriod)});
    along = next;
  }
  return rim;
}

}  // namespace

Stone MakeColumn() {
  // Grooves between the drums, a bulge below the capital.
  Mesh shaft = Lathe({{0.0, 0.15},
                      {0.34, 0.15},
                      {0.36, 0.21},
                      {0.33, 0.27},
                      {0.275, 0.30},
                      {0.272, 0.66},
                      {0.252, 0.675},
                      {0.268, 0.69},
                      {0.260, 1.05},
                      {0.240, 1.065},
                      {0.256, 1.08},
                      {0.240, 1.44},
                      {0.265, 1.47},
                      {0.240, 1.50},
                      {0.330, 1.60},
                      {0.330, 1.68},
                      {0.0, 1.70}},
                     20, 1.0, 1.0, 0.0);
  Wear(shaft);
  Mesh all = Block(0.0, {0.80, 0.80, 0.17}, {0.1, 0.4});
  all.Append(shaft);
  return {{"stone", std::move(all)}};
}

Stone MakePillar() {
  Mesh all = Block(0.0, {0.66, 0.66, 0.22}, {0.5, 0.1});
  all.Append(Block(0.20, {0.44, 0.44, 1.16}, {0.2, 0.6}));
  all.Append(Block(1.34, {0.60, 0.60, 0.14}, {0.7, 0.3}));
  all.Append(Block(1.47, {0.46, 0.46, 0.12}, {0.4, 0.9}));
  return {{"stone", std::move(all)}};
}

Stone MakeStele() {
  const std::vector<Vector2d> outline = SlabOutline();
  Mesh faces = SlabFace(outline, true);
  faces.Append(SlabFace(outline, false));
  Mesh rest = SlabRim(outline);
  rest.Append(Block(0.0, {0.96, 0.46, 0.18}, {0.3, 0.2}));
  return {{"inscription", std::move(faces)}, {"stone", std::move(rest)}};
}

}  // namespace drydock::scenes::columns
