#include "scenes/bus/debris.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "scenes/mesh/shapes.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;

Vector2d RandomShift(RandomStream& random) {
  const double u = random.Uniform();
  return {u, random.Uniform()};
}

Vector3d RandomGaussians(RandomStream& random) {
  const double x = random.Gaussian();
  const double y = random.Gaussian();
  return {x, y, random.Gaussian()};
}

/// A tapering, slightly crooked stem from `from` along `direction`.
Mesh Stem(const Vector3d& from, const Vector3d& direction, double radius, double taper, int steps,
          int segments, RandomStream& random) {
  std::vector<Vector3d> path;
  std::vector<double> radii;
  Vector3d bend = Vector3d::Zero();
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    bend += 0.12 * radius * RandomGaussians(random);
    path.push_back(from + t * direction + bend);
    radii.push_back(radius * (1 - t * (1 - taper)) * random.Uniform(0.92, 1.08));
  }
  return Tube(path, radii, segments, {1.0, RandomShift(random)});
}

}  // namespace

Object MakeBarrel(RandomStream& random) {
  const double r = 0.29;
  const Vector2d shift = RandomShift(random);
  Mesh barrel = Lathe({{r - 0.02, 0.02},
                       {r, 0.0},
                       {r, 0.27},
                       {r + 0.015, 0.29},
                       {r, 0.31},
                       {r, 0.57},
                       {r + 0.015, 0.59},
                       {r, 0.61},
                       {r, 0.88},
                       {r - 0.02, 0.88},
                       {r - 0.025, 0.86}},
                      15, 2.0, 0.0, 1.0);
  for (Vector2d& uv : barrel.uvs) uv += shift;
  const UvRect cap{shift, shift + Vector2d(0.6, 0.6)};
  Mesh lid = Disc(r - 0.02, 15, cap);
  for (Vector3d& p : lid.positions) p.z() = 0.86;
  Mesh bottom = Flipped(lid);
  for (Vector3d& p : bottom.positions) p.z() = 0.02;
  barrel.Append(lid);
  barrel.Append(bottom);
  const double paint = random.Uniform();
  return {{paint < 0.55 ? "bare_rust" : paint < 0.8 ? "black_paint" : "yellow_paint", barrel}};
}

Object MakeTyre(RandomStream& random) {
  Mesh tyre = Lathe({{0.20, 0.03},
                     {0.22, 0.0},
                     {0.33, 0.0},
                     {0.37, 0.04},
                     {0.38, 0.10},
                     {0.37, 0.16},
                     {0.33, 0.20},
                     {0.22, 0.20},
                     {0.20, 0.17},
                     {0.28, 0.15},
                     {0.34, 0.10},
                     {0.28, 0.05},
                     {0.20, 0.03}},
                    16, 2.0);
  const Vector2d shift(random.Uniform(), 0.0);
  for (Vector2d& uv : tyre.uvs) uv += shift;
  return {{"rubber", tyre}};
}

Object MakeLog(double length, double radius, RandomStream& random) {
  const Vector3d start(-length / 2, 0, 0.7 * radius);
  Mesh log = Stem(start, {length, 0, 0.05 * length}, radius, 0.6, 9, 10, random);
  const int branches = static_cast<int>(random.Uniform(2.5, 5.5));
  for (int i = 0; i < branches; ++i) {
    const double x = random.Uniform(-0.3, 0.45) * length;
    const double angle = random.Uniform(-0.3, 3.4);
    const double reach = random.Uniform(0.3, 0.9);
    const Vector3d direction(0.35 * reach, reach * std::cos(angle),
                             reach * std::max(0.2, std::sin(angle)));
    log.Append(Stem({x, 0, 0.7 * radius}, direction, 0.25 * radius, 0.3, 4, 6, random));
  }
  return {{"bark", log}};
}

Object MakeStump(RandomStream& random) {
  Mesh stump = Tube({{0, 0, -0.3}, {0.02, 0, 0.05}, {0.0, 0.02, 0.25}, {0.02, 0.03, 0.62}},
                    {0.46, 0.36, 0.29, 0.25}, 12, {1.0, RandomShift(random)});
  for (int i = 0; i < 6; ++i) {
    const double angle = kTurn * i / 6 + random.Uniform(-0.3, 0.3);
    const double reach = random.Uniform(0.6, 1.2);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    stump.Append(Tube({0.2 * out + Vector3d(0, 0, 0.15), 0.5 * out + Vector3d(0, 0, 0.12),
                       reach * out + Vector3d(0, 0, -0.12)},
                      {0.13, 0.09, 0.035}, 7, {1.0, RandomShift(random)}));
  }
  return {{"bark", stump}};
}

Object MakeTree(double length, RandomStream& random) {
  Mesh tree = Stem({-length / 2, 0, 0.18}, {length, 0, 0.5}, 0.23, 0.3, 8, 9, random);
  const int limbs = 11;
  for (int i = 0; i < limbs; ++i) {
    const double t = 0.35 + 0.6 * (i + 0.5) / limbs;
    const double angle = random.Uniform(-0.2, 3.34);  // about the trunk, mostly upwards
    const double reach = length * random.Uniform(0.18, 0.34) * (1.25 - 0.6 * t);
    const Vector3d root(length * (t - 0.5), 0, 0.2 + 0.45 * t);
    const Vector3d out(0.45 * reach, 0.8 * reach * std::cos(angle), 0.8 * reach * std::sin(angle));
    tree.Append(Stem(root, out, 0.075 * (1.3 - t), 0.35, 3, 5, random));
    for (int k = 1; k <= 2; ++k) {
      const Vector3d twig = 0.3 * out + 0.28 * reach * RandomGaussians(random);
      tree.Append(Stem(root + (0.35 + 0.25 * k) * out, twig, 0.03 * (1.3 - t), 0.3, 2, 3, random));
    }
  }
  return {{"bark", tree}};
}

Object MakePile(double height, double radius, RandomStream& random) {
  Vector3d up = 0.1 * RandomGaussians(random);
  up.z() = height + 0.5;
  return {{"bark", Stem({0, 0, -0.5}, up, radius, 0.85, 6, 10, random)}};
}

Object MakeCrate(RandomStream& random) {
  Mesh crate;
  const double s = 0.55;
  for (int side = 0; side < 4; ++side) {
    Mesh wall;
    for (int k = 0; k < 4; ++k) {
      if (random.Uniform() < 0.15) continue;
      wall.Append(Box({0, s / 2, 0.07 + 0.13 * k}, {s, 0.02, 0.11}, {1.0, RandomShift(random)}));
    }
    wall.Append(
        Box({-s / 2 + 0.03, s / 2 - 0.02, 0.27}, {0.06, 0.025, 0.54}, {1.0, RandomShift(random)}));
    wall.Transform(Eigen::Isometry3d(Eigen::AngleAxisd(kTurn * side / 4, Vector3d::UnitZ())));
    crate.Append(wall);
  }
  crate.Append(Box({0, 0, 0.03}, {s, s, 0.03}, {1.0, RandomShift(random)}));
  return {{"planks", crate}};
}

Object MakePallet(RandomStream& random) {
  Mesh pallet;
  for (int k = 0; k < 7; ++k) {
    pallet.Append(
        Box({-0.51 + 0.17 * k, 0, 0.13}, {0.12, 1.0, 0.022}, {1.0, RandomShift(random)}, 0.0, 1));
  }
  for (const double y : {-0.45, 0.0, 0.45}) {
    pallet.Append(Box({0, y, 0.06}, {1.15, 0.09, 0.10}, {1.0, RandomShift(random)}));
  }
  return {{"planks", pallet}};
}

Object MakeBlock(RandomStream& random) {
  const Vector2d shift = RandomShift(random);
  Mesh block;
  for (const double x : {-0.18, 0.0, 0.18})
    block.Append(Box({x, 0, 0.1}, {0.035, 0.19, 0.19}, {1.0, shift}));
  for (const double y : {-0.08, 0.08})
    block.Append(Box({0, y, 0.1}, {0.40, 0.03, 0.19}, {1.0, shift}));
  return {{"stone", block}};
}

Object MakePipe(double length, double radius, RandomStream& random) {
  const double r = radius - 0.07;
  Mesh pipe = Lathe({{r, 0.0},
                     {radius, 0.0},
                     {radius, length - 0.15},
                     {radius + 0.06, length - 0.14},
                     {radius + 0.06, length},
                     {r, length},
                     {r, 0.0}},
                    20, 2.0, 0.0, 2.0 * length);
  const Vector2d shift = RandomShift(random);
  for (Vector2d& uv : pipe.uvs) uv += shift;
  Eigen::Isometry3d lay(Eigen::AngleAxisd(kTurn / 4, Vector3d::UnitY()));
  lay.translation() = Vector3d(-length / 2, 0, 0.7 * radius);
  pipe.Transform(lay);
  return {{"stone", pipe}};
}

Object MakeBoat(RandomStream& random) {
  const double half = 1.8;
  const auto hull = [half](double s, double t) -> SurfacePoint {
    const double x = half * (2 * s - 1);
    const double along = 2 * s - 1;
    // Full at the stern, pointed at the bow.
    const double beam =
        0.62 * (along < 0 ? 1.0 - 0.25 * along * along : 1.0 - std::pow(along, 2.6));
    const double keel =
        0.10 * along * along + (along > 0.6 ? 0.6 * (along - 0.6) * (along - 0.6) : 0.0);
    const double angle = std::numbers::pi * (t - 0.5);
    const double y =
        beam * std::copysign(std::pow(std::abs(std::sin(angle)), 0.8), std::sin(angle));
    const double z =
        keel + (0.52 + 0.12 * along * along - keel) * std::pow(1 - std::cos(angle), 1.3);
    return {{x, y, z}, {1.4 * t, 1.2 * (s + 0.1)}};
  };
  Mesh inside = GridSheet(14, 12, hull);
  const Mesh outside = Flipped(inside);
  Mesh boat = outside;
  for (Vector3d& p : inside.positions)
    p = p.cwiseProduct(Vector3d(0.985, 0.96, 1.0)) + Vector3d(0, 0, 0.015);
  boat.Append(inside);
  for (const double x : {-1.1, -0.1, 0.8}) {
    boat.Append(Box({x, 0, 0.36}, {0.22, 1.1, 0.03}, {1.0, RandomShift(random)}));
  }
  boat.Append(Box({-1.78, 0, 0.38}, {0.04, 0.9, 0.42}, {1.0, RandomShift(random)}));
  return {{"planks", boat}};
}

Object MakeWeeds(double height, int blades, RandomStream& random) {
  Mesh weeds;
  for (int i = 0; i < blades; ++i) {
    const double angle = random.Uniform(0.0, kTurn);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d side(-out.y(), out.x(), 0);
    Vector3d root = 0.12 * std::sqrt(height) * RandomGaussians(random);
    root.z() = 0.0;
    const double tall = height * random.Uniform(0.45, 1.0);
    const double lean = random.Uniform(0.1, 0.5) * tall;
    const double width = random.Uniform(0.02, 0.04);
    std::vector<Vector3d> spine;
    std::vector<double> widths;
    for (int k = 0; k <= 3; ++k) {
      const double t = k / 3.0;
      const double wave = 0.06 * tall * std::sin(5 * t + angle);
      spine.push_back(root + out * (lean * t * t) + side * wave + Vector3d(0, 0, tall * t - 0.05));
      widths.push_back(width * (k == 3 ? 0.15 : 1.0 - 0.25 * t));
    }
    const double column = std::floor(random.Uniform(0.0, 8.0)) / 8.0;
    weeds.Append(Ribbon(spine, widths, side, {{column + 0.01, 0.02}, {column + 0.115, 0.98}}));
  }
  return {{"weeds", weeds}};
}

Object MakeBoulder(double size, int cells, RandomStream& random) {
  const double x = size * random.Uniform(0.8, 1.25);
  const double y = size * random.Uniform(0.75, 1.1);
  const Vector3d extent(x, y, size * random.Uniform(0.55, 0.95));
  const std::uint64_t key = random.Bits();
  Mesh rock = Rock(extent, cells, 0.42, key, {1.6, RandomShift(random)});
  for (Vector3d& p : rock.positions) p.z() += 0.22 * extent.z();
  return {{"stone", rock}};
}

Object MakeDrownedTree(double height, RandomStream& random) {
  Mesh tree = Stem({0, 0, -0.4}, {0.05 * height, 0.04 * height, height + 0.4}, 0.045 * height, 0.25,
                   5, 8, random);
  for (int i = 0; i < 4; ++i) {  // roots
    const double angle = kTurn * i / 4 + random.Uniform(-0.4, 0.4);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    tree.Append(Tube(
        {Vector3d(0, 0, 0.18), 0.3 * out + Vector3d(0, 0, 0.06), 0.7 * out - Vector3d(0, 0, 0.12)},
        {0.04 * height, 0.025 * height, 0.01 * height}, 5, {1.0, RandomShift(random)}));
  }
  const int limbs = 8;
  for (int i = 0; i < limbs; ++i) {
    const double t = 0.3 + 0.65 * (i + 0.5) / limbs;
    const double angle = 2.4 * i + random.Uniform(-0.4, 0.4);
    const double reach = 0.3 * height * random.Uniform(0.5, 1.0) * (1.2 - 0.6 * t);
    const Vector3d root(0.05 * height * t, 0.04 * height * t, height * t);
    const Vector3d out(0.9 * reach * std::cos(angle), 0.9 * reach * std::sin(angle), 0.45 * reach);
    tree.Append(Stem(root, out, 0.014 * height * (1.4 - t), 0.35, 3, 4, random));
    const Vector3d twig = 0.25 * out + 0.2 * reach * RandomGaussians(random);
    tree.Append(Stem(root + 0.6 * out, twig, 0.007 * height * (1.4 - t), 0.3, 2, 3, random));
  }
  return {{"bark", tree}};
}

Object MakeFenceSpan(double length, RandomStream& random) {
  const double tall = random.Uniform(1.3, 1.6);
  Mesh post =
      Stem({0, 0, -0.3}, {0.06 * random.Gaussian(), 0.05, tall + 0.3}, 0.075, 0.9, 3, 7, random);
  Mesh boards;
  for (const double z : {0.35, 0.75, 1.15}) {
    if (random.Uniform() < 0.12) continue;
    Mesh board =
        Box({length / 2, -0.07, 0}, {length + 0.2, 0.025, 0.15}, {1.0, RandomShift(random)});
    // Some hang by one nail.
    const double slope =
        random.Uniform() < 0.2 ? random.Uniform(0.15, 0.45) : 0.03 * random.Gaussian();
    board.Transform(Eigen::Translation3d(0, 0, z) * Eigen::AngleAxisd(slope, Vector3d::UnitY()));
    boards.Append(board);
  }
  return {{"bark", post}, {"planks", boards}};
}

Object MakeDeck(double length, double width, RandomStream& random) {
  Mesh deck;
  const double pitch = 0.23;
  for (int i = 0; i < static_cast<int>(length / pitch); ++i) {
    if (random.Uniform() < 0.1) continue;
    const double cut = random.Uniform() < 0.2 ? random.Uniform(0.3, 1.6) : 0.06 * random.Uniform();
    Mesh plank = Box({pitch * (i + 0.5), cut / 2, 0.0}, {0.19, width - cut, 0.04},
                     {2.0, RandomShift(random)}, 0.0, 1);
    plank.Transform(
        Eigen::Isometry3d(Eigen::AngleAxisd(0.012 * random.Gaussian(), Vector3d::UnitX())));
    deck.Append(plank);
  }
  for (const double y : {-0.4 * width, 0.0, 0.4 * width}) {
    deck.Append(
        Box({length / 2, y, -0.11}, {length + 0.3, 0.14, 0.18}, {1.0, RandomShift(random)}));
  }
  return {{"planks", deck}};
}

Object MakeLitter(RandomStream& random) {
  Mesh bottles;
  Mesh cans;
  for (int i = 0; i < 5; ++i) {
    const bool bottle = i % 2 == 0;
    Mesh thing = bottle
                     ? Lathe({{0.0, 0.0},
                              {0.036, 0.0},
                              {0.038, 0.16},
                              {0.014, 0.21},
                              {0.014, 0.26},
                              {0.0, 0.26}},
                             7, 1.0, 0.0, 0.4)
                     : Lathe({{0.0, 0.0}, {0.033, 0.0}, {0.034, 0.11}, {0.026, 0.12}, {0.0, 0.115}},
                             7, 1.0, 0.0, 0.3);
    const Vector2d shift = RandomShift(random);
    for (Vector2d& uv : thing.uvs) uv = 0.25 * uv + shift;
    const Vector3d place = 0.45 * RandomGaussians(random);
    const double yaw = random.Uniform(0.0, kTurn);
    const double tip = random.Uniform(1.2, 1.6);
    thing.Transform(Eigen::Translation3d(place.x(), place.y(), 0.03) *
                    Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tip, Vector3d::UnitX()));
    (bottle ? bottles : cans).Append(thing);
  }
  return {{"glass", bottles}, {"bare_rust", cans}};
}

void PlaceObject(Object& object, const Vector3d& position, double yaw, double tip_x, double tip_y) {
  const Eigen::Isometry3d pose =
      Eigen::Translation3d(position) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
      Eigen::AngleAxisd(tip_y, Vector3d::UnitY()) * Eigen::AngleAxisd(tip_x, Vector3d::UnitX());
  for (auto& [material, mesh] : object) mesh.Transform(pose);
}

}  // namespace drydock::scenes::bus
