#include "scenes/cemetery/stones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "scenes/cemetery/inscriptions.h"
#include "scenes/mesh/plate.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::cemetery {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStonePeriod = 1.5;  // [m], of the textures
constexpr double kBevel = 0.014;      // [m]

TileUv RandomTile(RandomStream& random) {
  const double u = random.Uniform();
  return {kStonePeriod, {u, random.Uniform()}};
}

/// What a stone is made of.
struct Stuff {
  std::string material;
  UvRect cell;   ///< of the inscription
  UvRect lines;  ///< of its text alone
};

/// A stone's parts: plain stone and what bears the inscription.
struct Parts {
  Mesh plain;
  Mesh inscribed;
};

Mesh Block(double z_low, const Vector3d& size, RandomStream& random) {
  const TileUv tile = RandomTile(random);
  return Box({0.0, 0.0, z_low + 0.5 * size.z()}, size, tile, 0.02, 2);
}

/// A plate along x and z, inscribed on its front, standing `forward` towards -y. `extent` is the
/// part of the x-z plane that the picture `cell` covers.
void AddPlate(Parts& parts, const Outline& outline, const Vector2d& middle, double thickness,
              double forward, const UvRect& cell, const UvRect& extent, RandomStream& random) {
  const TileUv tile = RandomTile(random);
  const Outline inner = Inset(outline, kBevel);
  const Vector2d size = extent.high - extent.low;
  Mesh front = PlateFace(inner, middle, -0.5 * thickness, [&](const Vector2d& p) -> Vector2d {
    return cell.At((p.x() - extent.low.x()) / size.x(), (extent.high.y() - p.y()) / size.y());
  });
  Mesh rest = PlateFace(inner, middle, 0.5 * thickness, [&](const Vector2d& p) -> Vector2d {
    return tile.offset + Vector2d(-p.x(), -p.y()) / tile.period;
  });
  rest.Append(PlateRim(outline, thickness, tile, kBevel));
  const Eigen::Isometry3d shift(Eigen::Translation3d(0.0, -forward, 0.0));
  front.Transform(shift);
  rest.Transform(shift);
  parts.inscribed.Append(front);
  parts.plain.Append(rest);
}

Outline Rectangle(double half_width, double low, double high) {
  return {{-half_width, low}, {half_width, low}, {half_width, high}, {-half_width, high}};
}

/// Some slabs have lost a corner.
Outline MaybeBroken(const Outline& outline, double half_width, double top, RandomStream& random) {
  const bool broken = random.Uniform() < 0.22;
  const double side = random.Uniform() < 0.5 ? -1.0 : 1.0;
  const double depth = random.Uniform(0.15, 0.42);
  const double slope = random.Uniform(0.5, 1.3);
  if (!broken) return outline;
  return Clip(outline, {side * half_width, top - depth}, {side * slope, 1.0});
}

/// A slab on a low foot; `outline` from z = foot up.
Parts SlabOnFoot(const Outline& whole, double half_width, double top, const Stuff& stuff,
                 RandomStream& random) {
  Parts parts;
  constexpr double kFoot = 0.12;
  const double thickness = random.Uniform(0.09, 0.14);
  const Outline outline = MaybeBroken(whole, half_width, top, random);
  // The picture keeps its proportions: it ends below the slab's top, or in the foot.
  const double low = top - 2.0 * half_width * kCellHeight / kCellWidth;
  AddPlate(parts, outline, {0.0, 0.35}, thickness, 0.0, stuff.cell,
           {{-half_width, low}, {half_width, top}}, random);
  parts.plain.Append(Block(0.0, {2.0 * half_width + 0.14, thickness + 0.16, kFoot + 0.02}, random));
  return parts;
}

Parts RoundTop(const Stuff& stuff, RandomStream& random) {
  const double half = random.Uniform(0.25, 0.33);
  const double top = random.Uniform(0.70, 0.92);
  const double rise = half * random.Uniform(0.45, 1.0);
  return SlabOnFoot(RoundTopOutline(half, 0.12, top - rise, rise, 12), half, top, stuff, random);
}

Parts Gabled(const Stuff& stuff, RandomStream& random) {
  const double half = random.Uniform(0.24, 0.31);
  const double top = random.Uniform(0.74, 0.98);
  const double eaves = top - half * random.Uniform(0.6, 0.95);
  const Outline outline = {{-half, 0.12}, {half, 0.12}, {half, eaves}, {0.0, top}, {-half, eaves}};
  return SlabOnFoot(outline, half, top, stuff, random);
}

Parts Cross(const Stuff& stuff, RandomStream& random) {
  const double scale = random.Uniform(0.9, 1.1);
  const double a = 0.075 * scale;  // half a beam's width
  const double arm = 0.27 * scale;
  const double z = 0.28 + 0.50 * scale;  // of the crossing
  const double top = z + 0.24 * scale;
  const double foot = 0.26;
  const double flare = 0.02 * scale;
  const Outline outline = {{-a - flare, foot},    {a + flare, foot},     {a, z - a},
                           {arm, z - a - flare},  {arm, z + a + flare},  {a, z + a},
                           {a + flare, top},      {-a - flare, top},     {-a, z + a},
                           {-arm, z + a + flare}, {-arm, z - a - flare}, {-a, z - a}};
  Parts parts;
  Mesh cross = PlateRim(outline, 0.13, RandomTile(random), kBevel);
  for (const double side : {-1.0, 1.0}) {
    const TileUv tile = RandomTile(random);
    cross.Append(PlateFace(Inset(outline, kBevel), {0.0, z}, side * 0.065,
                           [&](const Vector2d& p) -> Vector2d {
                             return tile.offset + Vector2d(-side * p.x(), -p.y()) / tile.period;
                           }));
  }
  parts.plain.Append(cross);
  parts.plain.Append(Block(0.0, {0.52, 0.34, 0.28}, random));
  AddPlate(parts, Rectangle(0.225, 0.04, 0.25), {0.0, 0.15}, 0.05, 0.155, stuff.lines,
           {{-0.225, 0.02}, {0.225, 0.27}}, random);
  return parts;
}

/// A low block with a slanted face.
Parts Pillow(const Stuff& stuff, RandomStream& random) {
  const double half = random.Uniform(0.27, 0.35);
  const double back = random.Uniform(0.38, 0.52);
  const double front = 0.5 * back;
  const TileUv tile = RandomTile(random);
  const double y0 = -0.20;
  const double y1 = -0.06;
  const double y2 = 0.20;
  const auto uv = [&](double u, double v) -> Vector2d {
    return tile.offset + Vector2d(u, v) / tile.period;
  };
  // The section in y and z, along the outside: the face, the top, the back, the bottom, the front.
  const std::vector<Vector2d> section = {{y0, front}, {y1, back}, {y2, back}, {y2, 0.0}, {y0, 0.0}};
  Parts parts;
  double along = 0.0;
  for (std::size_t i = 0; i < section.size(); ++i) {
    const Vector2d& p = section[i];
    const Vector2d& q = section[(i + 1) % section.size()];
    const double next = along + (q - p).norm();
    const std::array<Vector3d, 4> corners = {
        Vector3d(-half, p.x(), p.y()), Vector3d(half, p.x(), p.y()), Vector3d(half, q.x(), q.y()),
        Vector3d(-half, q.x(), q.y())};
    if (i == 0) {
      parts.inscribed.AddQuad(corners, {stuff.lines.At(0, 1), stuff.lines.At(1, 1),
                                        stuff.lines.At(1, 0), stuff.lines.At(0, 0)});
    } else {
      parts.plain.AddQuad(corners,
                          {uv(0, along), uv(2 * half, along), uv(2 * half, next), uv(0, next)});
    }
    along = next;
  }
  for (const double side : {-1.0, 1.0}) {
    Mesh end;
    std::vector<int> ring;
    ring.reserve(section.size());
    for (const Vector2d& p : section) {
      ring.push_back(
          end.AddVertex({side * half, p.x(), p.y()}, side * Vector3d::UnitX(), uv(p.x(), -p.y())));
    }
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      if (side > 0) end.AddTriangle(ring[0], ring[i + 1], ring[i]);
      if (side < 0) end.AddTriangle(ring[0], ring[i], ring[i + 1]);
    }
    parts.plain.Append(end);
  }
  return parts;
}

/// A square spire: half widths and heights from the foot up.
Mesh Spire(const std::vector<Vector2d>& profile, const TileUv& tile) {
  Mesh spire;
  for (int side = 0; side < 4; ++side) {
    Mesh face;
    double along = 0.0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      const double a = profile[i].x();
      const double b = profile[i + 1].x();
      const double next = along + (profile[i + 1] - profile[i]).norm();
      const auto uv = [&](double x, double v) -> Vector2d {
        return tile.offset + Vector2d(x + 0.4 * side, -v) / tile.period;
      };
      face.AddQuad({Vector3d(-a, -a, profile[i].y()), Vector3d(a, -a, profile[i].y()),
                    Vector3d(b, -b, profile[i + 1].y()), Vector3d(-b, -b, profile[i + 1].y())},
                   {uv(-a, along), uv(a, along), uv(b, next), uv(-b, next)});
      along = next;
    }
    face.Transform(
        Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * std::numbers::pi * side, Vector3d::UnitZ())));
    spire.Append(face);
  }
  // On the axis a quadrangle is one triangle.
  std::erase_if(spire.triangles, [&](const std::array<int, 3>& t) {
    const Vector3d ab = spire.positions[t[1]] - spire.positions[t[0]];
    const Vector3d ac = spire.positions[t[2]] - spire.positions[t[0]];
    return ab.cross(ac).squaredNorm() < 1e-18;
  });
  return spire;
}

Parts Obelisk(const Stuff& stuff, RandomStream& random) {
  const double top = random.Uniform(1.12, 1.35);
  Parts parts;
  parts.plain.Append(Block(0.0, {0.56, 0.56, 0.14}, random));
  parts.plain.Append(Block(0.13, {0.44, 0.44, 0.30}, random));
  const TileUv tile = RandomTile(random);
  // Closed below and above by points on the axis.
  parts.plain.Append(
      Spire({{0.0, 0.42}, {0.18, 0.42}, {0.18, 0.48}, {0.14, 0.51}, {0.10, top - 0.14}, {0.0, top}},
            tile));
  AddPlate(parts, Rectangle(0.185, 0.16, 0.41), {0.0, 0.3}, 0.04, 0.215, stuff.lines,
           {{-0.2, 0.15}, {0.2, 0.42}}, random);
  return parts;
}

Parts MakeParts(Shape shape, const Stuff& stuff, RandomStream& random) {
  switch (shape) {
    case Shape::kRoundTop:
      return RoundTop(stuff, random);
    case Shape::kGabled:
      return Gabled(stuff, random);
    case Shape::kCross:
      return Cross(stuff, random);
    case Shape::kPillow:
      return Pillow(stuff, random);
    case Shape::kObelisk:
      break;
  }
  return Obelisk(stuff, random);
}

}  // namespace

Object MakeStone(Shape shape, int inscription, RandomStream& random) {
  const Stuff stuff{IsPale(inscription) ? "limestone" : "slate", InscriptionCell(inscription),
                    InscriptionCell(inscription, true)};
  Parts parts = MakeParts(shape, stuff, random);
  const std::uint64_t key = random.Bits();
  for (Mesh* mesh : {&parts.plain, &parts.inscribed}) Wear(*mesh, 0.16, 0.018, key);
  return {{stuff.material, std::move(parts.plain)}, {"inscriptions", std::move(parts.inscribed)}};
}

Object MakeUrn(RandomStream& random) {
  const double scale = random.Uniform(0.85, 1.15);
  Mesh urn = Lathe({{0.0, -0.04},
                    {0.085, -0.04},
                    {0.085, 0.03},
                    {0.035, 0.06},
                    {0.040, 0.09},
                    {0.105, 0.17},
                    {0.110, 0.22},
                    {0.080, 0.26},
                    {0.105, 0.30},
                    {0.060, 0.29},
                    {0.0, 0.24}},
                   9, 0.4, 0.25, 0.0);
  for (Vector3d& p : urn.positions) p *= scale;
  return {{random.Uniform() < 0.6 ? "limestone" : "slate", std::move(urn)}};
}

Object MakeKerb(double width, double length, RandomStream& random) {
  constexpr double kThick = 0.09;
  constexpr double kTall = 0.22;
  Mesh kerb;
  const auto bar = [&](const Vector3d& center, const Vector3d& size, int axis) {
    const TileUv tile = RandomTile(random);
    const double yaw = 0.04 * random.Gaussian();
    const double tip = 0.05 * random.Gaussian();
    Mesh piece = Box(Vector3d::Zero(), size, tile, 0.015, axis);
    piece.Transform(
        Eigen::Translation3d(center.x(), center.y(), 0.02 * random.Gaussian()) *
        Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
        Eigen::AngleAxisd(tip, size.x() > size.y() ? Vector3d::UnitY() : Vector3d::UnitX()));
    kerb.Append(piece);
  };
  for (const double side : {-0.5, 0.5}) {
    bar({side * width, -0.5 * length, 0.0}, {kThick, length, kTall}, 1);
  }
  bar({0.0, -length, 0.0}, {width - kThick, kThick, kTall}, 0);
  return {{random.Uniform() < 0.7 ? "limestone" : "slate", std::move(kerb)}};
}

Object MakeShard(double size, RandomStream& random) {
  Outline outline;
  const int corners = 5 + static_cast<int>(random.Uniform(0.0, 3.0));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.Uniform(0.0, 0.6)) / corners;
    const double radius = 0.5 * size * random.Uniform(0.7, 1.1);
    outline.emplace_back(radius * std::cos(angle), 0.7 * radius * std::sin(angle));
  }
  const double thickness = random.Uniform(0.07, 0.12);
  const TileUv tile = RandomTile(random);
  Mesh shard = PlateRim(outline, thickness, tile);
  for (const double side : {-0.5, 0.5}) {
    shard.Append(
        PlateFace(outline, Vector2d::Zero(), side * thickness,
                  [&](const Vector2d& p) -> Vector2d { return tile.offset + p / tile.period; }));
  }
  // Flat on the ground.
  shard.Transform(Eigen::Isometry3d(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vector3d::UnitX())));
  const std::uint64_t key = random.Bits();
  Wear(shard, 0.12, 0.02, key);
  return {{random.Uniform() < 0.6 ? "limestone" : "slate", std::move(shard)}};
}

Object MakeRailing(double length, double height, RandomStream& random) {
  Mesh iron;
  const auto tile = [&random]() -> TileUv {
    const double u = random.Uniform();
    return {0.8, {u, random.Uniform()}};
  };
  const int bars = std::max(2, static_cast<int>(std::lround(length / 0.15)));
  for (int i = 0; i <= bars; ++i) {
    if (i > 0 && i < bars && random.Uniform() < 0.08) continue;
    const bool post = i == 0 || i == bars;
    const double width = post ? 0.045 : 0.022;
    const double tall = post ? height + 0.06 : height * random.Uniform(0.94, 1.0);
    const double lean = 0.03 * random.Gaussian();
    Mesh bar = Box({0.0, 0.0, 0.5 * tall - 0.1}, {width, width, tall + 0.2}, tile(), 0.0, 2);
    bar.Transform(Eigen::Translation3d(length * i / bars, 0.0, 0.0) *
                  Eigen::AngleAxisd(lean, Vector3d::UnitY()));
    iron.Append(bar);
  }
  for (const double z : {0.12, height - 0.06}) {
    iron.Append(Box({0.5 * length, 0.0, z}, {length, 0.012, 0.035}, tile(), 0.0, 0));
  }
  return {{"iron", std::move(iron)}};
}

}  // namespace drydock::scenes::cemetery
