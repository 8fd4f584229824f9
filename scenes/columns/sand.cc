#include "scenes/columns/sand.h"

#include <numbers>

#include <fmt/format.h>

#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::columns {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

// The sand reaches so far beyond the rows that the haze ends it.
constexpr int kTilesX = 8;
constexpr int kTilesY = 7;
constexpr int kCells = 10;
const Vector2d kCorner(-14.5, -26.0);

}  // namespace

Sand::Sand(std::uint64_t seed) : key_(RandomStream(seed, "columns/sand").BitsAt(0)) {}

double Sand::Height(double x, double y) const {
  const Vector2d p(x, y);
  return -1.15 + 0.14 * Fbm2(p / 5.0, 2, key_) + 0.05 * Fbm2(p / 1.4, 2, key_ + 7);
}

void AddSand(SceneModel& model, const Sand& sand) {
  for (int j = 0; j < kTilesY; ++j) {
    for (int i = 0; i < kTilesX; ++i) {
      const Vector2d corner = kCorner + kSandTile * Vector2d(i, j);
      const auto height = [&](const Vector2d& p) { return sand.Height(p.x(), p.y()); };
      const auto uv = [&](const Vector2d& p) -> Vector2d {
        const Vector2d place = (p - corner) / kSandTile;
        return {place.x(), 1.0 - place.y()};
      };
      model.Add("sand", "sand", GroundTile(corner, kSandTile, kCells, height, uv));
    }
  }
}

void AddRubble(SceneModel& model, const Sand& sand, std::uint64_t seed) {
  constexpr int kCount = 90;
  RandomStream random(seed, "columns/rubble");
  const Mesh form = Rock({1.0, 0.8, 0.5}, 3, 0.3, 5, {1.7, {0.0, 0.0}});
  for (int i = 0; i < kCount; ++i) {
    const double size = random.Uniform(0.12, 0.45);
    const double x = random.Uniform(-4.0, 24.0);
    const double y = random.Uniform(-16.0, 6.0);
    const double yaw = random.Uniform(0.0, 2.0 * std::numbers::pi);
    Mesh rock = form;
    for (Vector3d& p : rock.positions) p *= size;
    rock.Transform(Eigen::Translation3d(x, y, sand.Height(x, y)) *
                   Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
    model.Add(fmt::format("rubble_{:02}", i), "stone", std::move(rock));
  }
}

}  // namespace drydock::scenes::columns
