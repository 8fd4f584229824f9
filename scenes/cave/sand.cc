#include <cmath>
#include <utility>
#include <vector>

#include "scenes/cave/ground.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTile = 3.0;  // [m]
constexpr int kCells = 20;

Vector2d SandUv(const Vector2d& p, std::uint64_t key) {
  const Vector2d bend(Fbm2(p / 4.3, 2, key), Fbm2(p / 4.3, 2, key + 7));
  const Vector2d q = (p + 1.1 * bend) / kSandTile;
  return {q.x(), 1.0 - q.y()};
}

}  // namespace

void AddSand(SceneModel& model, const RockField& rock, const SandFloor& sand, std::uint64_t seed) {
  const std::uint64_t key = RandomStream(seed, "cave/sand_uv").BitsAt(0);
  constexpr double kInside = 0.6;  // So far into the rock it goes on [m].
  const Eigen::AlignedBox3d box = BoundsOf(rock.plan(), 0.5);
  const int columns = static_cast<int>(std::ceil(box.sizes().x() / kTile));
  const int rows = static_cast<int>(std::ceil(box.sizes().y() / kTile));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Vector2d corner = box.min().head<2>() + kTile * Vector2d(i, j);
      const Mesh tile = GroundTile(
          corner, kTile, kCells, [&](const Vector2d& p) { return sand.Height(p.x(), p.y()); },
          [key](const Vector2d& p) { return SandUv(p, key); });
      Mesh seen = tile;
      seen.Erase([&](const Vector3d& p) { return rock.At(p) < -kInside; });
      // A few triangles are no mesh that MuJoCo takes.
      const bool is_scrap = !seen.IsEmpty() && seen.triangles.size() < 12;
      model.Add("sand", "sand", is_scrap ? tile : seen);
    }
  }
}

}  // namespace drydock::scenes::cave
