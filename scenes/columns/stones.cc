#include "scenes/columns/stones.h"

#include "scenes/mesh/plate.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::columns {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStonePeriod = 1.7;  // [m], of the texture

Mesh Block(double z_low, const Vector3d& size, const Vector2d& shift) {
  return Box({0.0, 0.0, z_low + 0.5 * size.z()}, size, {kStonePeriod, shift}, 0.03, 2);
}

constexpr double kSlabHalf = 0.38;       // [m]
constexpr double kSlabThickness = 0.20;  // [m]
constexpr double kSlabFoot = 0.16;       // [m]
constexpr double kSlabShoulder = 1.10;   // [m]
constexpr double kSlabTop = kSlabShoulder + kSlabHalf;

/// The picture's place on both faces, upright on either.
Vector2d SlabUv(const Vector2d& p, double side) {
  return {0.5 - side * 0.5 * p.x() / kSlabHalf, (kSlabTop - p.y()) / (kSlabTop - kSlabFoot)};
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
  // Of shapes alone: the same wear on every copy of any seed.
  Wear(shaft, 0.22, 0.014, 11);
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
  const Outline outline = RoundTopOutline(kSlabHalf, kSlabFoot, kSlabShoulder, kSlabHalf, 14);
  Mesh faces;
  for (const double side : {-1.0, 1.0}) {
    faces.Append(PlateFace(outline, {0.0, 0.7}, 0.5 * side * kSlabThickness,
                           [side](const Vector2d& p) { return SlabUv(p, side); }));
  }
  Mesh rest = PlateRim(outline, kSlabThickness, {kStonePeriod, Vector2d::Zero()});
  rest.Append(Block(0.0, {0.96, 0.46, 0.18}, {0.3, 0.2}));
  return {{"inscription", std::move(faces)}, {"stone", std::move(rest)}};
}

}  // namespace drydock::scenes::columns
