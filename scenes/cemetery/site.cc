#include "scenes/cemetery/site.h"

#include <algorithm>
#include <cmath>

#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "scenes/mesh/smooth_step.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cemetery {
namespace {
using Eigen::Vector2d;

const Vector2d kMiddle(0.5 * (kWest + kEast), 0.5 * (kSouth + kNorth));

}  // namespace

double SignedDistanceToWay(const Vector2d& p) {
  const Vector2d half(0.5 * (kEast - kWest), 0.5 * (kNorth - kSouth));
  const Vector2d q = (p - kMiddle).cwiseAbs() - half + Vector2d::Constant(kCornerRadius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - kCornerRadius;
}

double DistanceToWay(const Vector2d& p) { return std::abs(SignedDistanceToWay(p)); }

double CeilingAt(const Vector2d& p) {
  constexpr double kRoom = 0.55;  // Around the body's path, sway and rounded corners included.
  constexpr double kHigh = 0.3;
  const double distance = DistanceToWay(p);
  return distance >= kRoom + 0.2 ? kHigh : -kRoom;
}

Ground::Ground(std::uint64_t seed) : key_(RandomStream(seed, "cemetery/ground").BitsAt(0)) {}

double Ground::Height(const Vector2d& p) const {
  double z = -0.95 + 0.13 * Fbm2(p / 5.5, 2, key_) + 0.07 * Fbm2(p / 2.0, 2, key_ + 7);
  // A rim that rises out of sight.
  const double radius = (p - kMiddle).norm() + 1.5 * Fbm2(p / 7.0, 2, key_ + 21);
  z += 2.4 * SmoothStep(12.5, 21.0, radius);
  return z;
}

Vector2d Ground::Uv(const Vector2d& p) const {
  constexpr double kBend = 0.9;   // [m]
  constexpr double kTurn = 0.47;  // [rad]
  const Vector2d q = p / 4.5;
  const Vector2d bent = p + kBend * Vector2d(Fbm2(q, 1, key_ + 41), Fbm2(q, 1, key_ + 42));
  const double c = std::cos(kTurn);
  const double s = std::sin(kTurn);
  return Vector2d(c * bent.x() - s * bent.y(), -s * bent.x() - c * bent.y()) / kSiltPeriod;
}

void AddGround(SceneModel& model, const Ground& ground) {
  constexpr int kTiles = 7;
  constexpr int kCells = 10;
  constexpr double kTile = 6.0;  // [m]
  for (int j = 0; j < kTiles; ++j) {
    for (int i = 0; i < kTiles; ++i) {
      const Vector2d corner = kMiddle + kTile * Vector2d(i - 0.5 * kTiles, j - 0.5 * kTiles);
      model.Add("ground", "silt",
                GroundTile(
                    corner, kTile, kCells, [&](const Vector2d& p) { return ground.Height(p); },
                    [&](const Vector2d& p) { return ground.Uv(p); }));
    }
  }
}

}  // namespace drydock::scenes::cemetery
