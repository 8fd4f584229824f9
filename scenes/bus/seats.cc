// Two rows of benches, worn to different degrees.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/parts.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kRows = 8;
constexpr double kFirstRow = 2.55;
constexpr double kPitch = 0.80;
constexpr double kBenchWidth = 0.63;
constexpr double kBenchMiddle = 0.79;  // of a bench, from the centreline

struct Wear {
  double lean = 0.0;  ///< of the back [rad]
  double tilt = 0.0;  ///< of the cushion [rad]
  bool cushion = true;
  bool back = true;
};

Wear RandomWear(RandomStream& random) {
  Wear wear;
  wear.lean = -0.14 + 0.05 * random.Gaussian();
  if (random.Uniform() < 0.15) wear.lean = random.Uniform(-0.5, -0.3);
  wear.tilt = 0.03 * random.Gaussian();
  if (random.Uniform() < 0.2) wear.tilt = random.Uniform(0.15, 0.4);
  wear.cushion = random.Uniform() > 0.12;
  wear.back = random.Uniform() > 0.08;
  return wear;
}

/// Around y through `pivot`.
Eigen::Isometry3d Lean(const Vector3d& pivot, double angle) {
  return Eigen::Translation3d(pivot) * Eigen::AngleAxisd(angle, Vector3d::UnitY()) *
         Eigen::Translation3d(-pivot);
}

/// The upholstery's lower corner at the origin, the bench along y.
Mesh Upholstery(const Vector3d& foot, const Wear& wear, const Vector2d& shift) {
  Mesh mesh;
  const Vector3d hinge = foot + Vector3d(-0.21, 0, 0.0);
  if (wear.cushion) {
    Mesh cushion =
        Box(foot + Vector3d(0, 0, 0.0), {0.44, kBenchWidth, 0.13}, {2.0, shift}, 0.035, 1);
    cushion.Transform(Lean(hinge, wear.tilt));
    mesh.Append(cushion);
  }
  if (wear.back) {
    Mesh back = Box(hinge + Vector3d(-0.02, 0, 0.30), {0.085, kBenchWidth, 0.62},
                    {2.0, shift + Vector2d(0.37, 0.53)}, 0.035, 1);
    Mesh top = Box(hinge + Vector3d(-0.02, 0, 0.625), {0.075, kBenchWidth - 0.06, 0.04},
                   {2.0, shift + Vector2d(0.11, 0.83)}, 0.018, 1);
    back.Append(top);
    back.Transform(Lean(hinge, wear.lean));
    mesh.Append(back);
  }
  return mesh;
}

/// Legs, the frame under the cushion, the hoop inside the back (seen where the back is gone).
Mesh Frame(const Vector3d& foot, const Wear& wear, double aisle_side) {
  const double half = kBenchWidth / 2 - 0.03;
  const TileUv uv{0.5, {0.3 * foot.x(), 0.2}};
  const double z = foot.z() - 0.075;
  const double aisle = foot.y() + aisle_side * half;
  const double wall = foot.y() - aisle_side * half;
  Mesh mesh;
  mesh.Append(Tube({{foot.x() - 0.18, aisle, kFloor - 0.02},
                    {foot.x() - 0.14, aisle, z},
                    {foot.x() + 0.16, aisle, z},
                    {foot.x() + 0.2, aisle, kFloor - 0.02}},
                   0.015, 5, uv));
  mesh.Append(Tube({{foot.x() - 0.16, wall, z}, {foot.x() - 0.16, aisle, z}}, 0.014, 5, uv));
  mesh.Append(Tube({{foot.x() + 0.16, wall, z}, {foot.x() + 0.16, aisle, z}}, 0.014, 5, uv));
  if (!wear.back) {
    const double x = foot.x() - 0.22;
    mesh.Append(Tube({{x, wall, z},
                      {x - 0.07, wall, z + 0.6},
                      {x - 0.075, 0.5 * (wall + aisle), z + 0.68},
                      {x - 0.07, aisle, z + 0.6},
                      {x, aisle, z}},
                     0.014, 5, uv));
  }
  return mesh;
}

void AddSeat(SceneModel& model, const std::string& name, const Vector3d& foot,
             RandomStream& random) {
  const Wear wear = RandomWear(random);
  const double shift_u = random.Uniform();
  const Vector2d shift(shift_u, random.Uniform());
  model.Add(name, "vinyl", Upholstery(foot, wear, shift));
  model.Add(name, "bare_rust", Frame(foot, wear, foot.y() > 0 ? -1.0 : 1.0));
}

}  // namespace

void AddSeats(SceneModel& model, std::uint64_t seed) {
  RandomStream random(seed, "bus/seats");
  for (int row = 0; row < kRows; ++row) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3d foot(kFirstRow + kPitch * row, kBenchMiddle * side, kFloor + 0.43);
      AddSeat(model, fmt::format("bus_seat_{}_{}", row, side > 0 ? "left" : "right"), foot, random);
    }
  }
  // The driver's, narrower.
  Mesh seat;
  seat.Append(Box({9.40, 0.72, -0.14}, {0.44, 0.48, 0.12}, {2.0, {0.15, 0.65}}, 0.04, 1));
  Mesh back = Box({9.16, 0.72, 0.20}, {0.10, 0.48, 0.62}, {2.0, {0.55, 0.15}}, 0.04, 1);
  back.Transform(Lean({9.16, 0.72, -0.1}, -0.12));
  seat.Append(back);
  model.Add("bus_driver_seat", "vinyl", std::move(seat));
  model.Add("bus_driver_seat", "bare_rust",
            Tube({{9.40, 0.72, kFloor}, {9.40, 0.72, -0.2}}, 0.06, 10, {0.5, {0.2, 0.2}}));
}

}  // namespace drydock::scenes::bus
