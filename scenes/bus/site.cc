#include "scenes/bus/site.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "scenes/bus/bus_shape.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "scenes/mesh/smooth_step.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector2d kMiddle(6.2, kBusY);
constexpr int kHalf = kTiles / 2;

Vector2d TileCorner(int i, int j) {
  return kMiddle + kTile * Vector2d(i - kHalf - 0.5, j - kHalf - 0.5);
}

/// Finer near the bus; beyond the bed's rim there is nothing, as fine as its neighbour.
int CellsOfTile(int i, int j) {
  const int ring = std::max(std::abs(i - kHalf), std::abs(j - kHalf));
  return ring <= 1 ? 18 : ring == 2 ? 10 : 6;
}

/// Two tiles meet on the coarser one's lines: straight between them.
double EdgeHeight(const LakeBed& bed, const Vector2d& from, const Vector2d& to, double t,
                  int cells) {
  const double at = t * cells;
  const double low = std::min(std::floor(at + 1e-9), cells - 1.0);
  const Vector2d a = from + (to - from) * (low / cells);
  const Vector2d b = from + (to - from) * ((low + 1) / cells);
  const double f = at - low;
  return (1 - f) * bed.Height(a.x(), a.y()) + f * bed.Height(b.x(), b.y());
}

Mesh Tile(const LakeBed& bed, int i, int j, RandomStream& random) {
  const int cells = CellsOfTile(i, j);
  const Vector2d corner = TileCorner(i, j);
  // The picture is bent inside each tile, so that equal ones do not look it. It stays at the rim.
  const auto within = [&random](double bound) {
    const double u = random.Uniform(-bound, bound);
    return Vector2d(u, random.Uniform(-bound, bound));
  };
  const Vector2d bend = within(0.07);
  const Vector2d swirl = within(0.05);
  const auto height = [&](double s, double t) {
    const auto edge = [&](int di, int dj, double x0, double y0, double x1, double y1,
                          double along) {
      const int shared = std::min(cells, CellsOfTile(i + di, j + dj));
      return EdgeHeight(bed, corner + kTile * Vector2d(x0, y0), corner + kTile * Vector2d(x1, y1),
                        along, shared);
    };
    if (s == 0.0) return edge(-1, 0, 0, 0, 0, 1, t);
    if (s == 1.0) return edge(1, 0, 1, 0, 1, 1, t);
    if (t == 0.0) return edge(0, -1, 0, 0, 1, 0, s);
    if (t == 1.0) return edge(0, 1, 0, 1, 1, 1, s);
    return bed.Height(corner.x() + kTile * s, corner.y() + kTile * t);
  };
  return GridSheet(cells, cells, [&](double s, double t) -> SurfacePoint {
    const double in_s = std::sin(std::numbers::pi * s);
    const double in_t = std::sin(std::numbers::pi * t);
    const double window = in_s * in_s * in_t * in_t;
    const Vector2d turn = swirl.cwiseProduct(Vector2d(std::sin(4 * t), std::sin(4 * s)));
    return {{corner.x() + kTile * s, corner.y() + kTile * t, height(s, t)},
            Vector2d(s, 1 - t) + window * (bend + turn)};
  });
}

}  // namespace

LakeBed::LakeBed(std::uint64_t seed) : key_(RandomStream(seed, "bus/bed").BitsAt(0)) {}

double LakeBed::Height(double x, double y) const {
  const Vector2d p(x, y);
  // A gentle slope, dunes of three sizes, a rim that rises out of sight.
  double z = -1.45 + 0.022 * (y - kBusY) - 0.008 * (x - kMiddle.x());
  z += 0.22 * Fbm2(p / 6.5, 2, key_) + 0.10 * Fbm2(p / 2.1, 2, key_ + 7) +
       0.05 * Fbm2(p / 0.8, 2, key_ + 13);
  const double radius = (p - kMiddle).norm() + 1.5 * Fbm2(p / 7.0, 2, key_ + 21);
  z += 2.6 * SmoothStep(13.5, 22.0, radius);
  // Scour around the bus, drifts against it.
  const double d = DistanceToBus(x, y);
  const double drift = 0.5 + 0.7 * Fbm2(p / 2.6, 2, key_ + 31);
  z -= 0.13 * std::exp(-std::pow((d - 0.7) / 0.5, 2));
  z += 0.36 * std::max(0.0, drift) * std::exp(-std::pow(std::max(d, -0.6) / 0.55, 2));
  return z;
}

void AddLakeBed(SceneModel& model, const LakeBed& bed, std::uint64_t seed) {
  RandomStream random(seed, "bus/bed_tiles");
  for (int j = 0; j < kTiles; ++j) {
    for (int i = 0; i < kTiles; ++i) {
      const int variant = (i + 2 * j + (j / 3)) % kBedVariants;
      model.Add("lake_bed", fmt::format("bed_{}", variant), Tile(bed, i, j, random));
    }
  }
}

Corridor::Corridor() {
  const std::vector<Vector3d> way = {
      {-1.0, 0.0, 0.0},   {0, 0, 0},          {6, 0, 0},        {12, 0.2, 0.1},   {13.8, -1.0, 0.2},
      {14.2, -3.2, 0.3},  {13.8, -5.5, 0.25}, {12, -6.6, 0.2},  {6.5, -6.6, 0.1}, {1, -6.5, 0.0},
      {-0.8, -5.4, 0.05}, {-1.2, -3.2, 0.1},  {1.5, -3.2, 0.3}, {10, -3.2, 0.5},  {12, -3.2, 2.0}};
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    for (int k = 0; k < 20; ++k) points_.push_back(way[i] + (way[i + 1] - way[i]) * (k / 20.0));
  }
  points_.push_back(way.back());
}

double Corridor::HorizontalDistance(double x, double y) const {
  double nearest = std::numeric_limits<double>::max();
  for (const Vector3d& p : points_) nearest = std::min(nearest, std::hypot(p.x() - x, p.y() - y));
  return nearest;
}

double DistanceToBus(double x, double y) {
  const double dx = std::max(kRear - x, x - 12.1);
  const double dy = std::abs(y - kBusY) - kHalfWidth;
  if (dx <= 0 && dy <= 0) return std::max(dx, dy);
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
}

}  // namespace drydock::scenes::bus
