// Inside the bus: floor, ribs, the driver's place.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/parts.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kChunks = 3;
constexpr double kPi = std::numbers::pi;

/// Silt on the floor: thin in the aisle, drifts along the walls and at the rear.
double SiltDepth(double x, double y, std::uint64_t key) {
  const double noise = 0.5 + 0.5 * Fbm2({1.3 * x, 1.3 * y}, 4, key);
  const double wall = std::clamp((std::abs(y) - 0.5) / 0.6, 0.0, 1.0);
  const double patches = std::max(0.0, Fbm2({0.7 * x, 0.9 * y}, 3, key + 9));
  return 0.006 + 0.03 * noise * patches + 0.13 * wall * wall * noise;
}

void AddFloor(SceneModel& model, std::uint64_t seed) {
  const std::uint64_t key = RandomStream(seed, "bus/silt").BitsAt(0);
  const double rear = kRear + 0.02;
  const double front = kFront + 0.1;
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    model.Add("bus_floor", "floor", GridSheet(15, 10, [&](double s, double t) -> SurfacePoint {
                const double x = rear + (front - rear) * (chunk + s) / kChunks;
                const double y = (2 * t - 1) * (kHalfWidth - 0.05);
                const Vector3d p(x, y, kFloor + SiltDepth(x, y, key));
                return {p, FloorUv(p)};
              }));
  }
  Mesh boxes;  // over the rear wheels
  for (const double side : {-1.0, 1.0}) {
    boxes.Append(
        Box({kRearAxle, 0.95 * side, kFloor + 0.06}, {1.2, 0.4, 0.16}, {1.0, {0.5, 0.2}}, 0.04, 1));
  }
  model.Add("bus_wheel_boxes", "panel", std::move(boxes));
  Mesh steps;
  steps.Append(Box({9.88, -0.98, -0.80}, {0.56, 0.34, 0.06}, {1.0, {0.1, 0.2}}));
  steps.Append(Box({9.88, -1.08, -1.02}, {0.56, 0.2, 0.06}, {1.0, {0.6, 0.2}}));
  model.Add("bus_steps", "bare_rust", std::move(steps));
}

/// A hoop along walls and ceiling.
Mesh Rib(double x, double shift) {
  std::vector<Vector3d> path;
  const double half_width = kHalfWidth - kWall - 0.018;
  const double end = EndFactor(std::min(x - kRear, kFront - x) - kWall);
  path.emplace_back(x, -half_width, kFloor);
  for (std::size_t k = 0; k < RoofLines().size(); k += 2) {
    const double y = RoofLines()[k];
    path.emplace_back(x, y * half_width, kEave + (kCeilingRise * end - 0.02) * RoofFraction(y));
  }
  path.emplace_back(x, half_width, kFloor);
  return Tube(path, 0.027, 4, {0.5, {shift, 0.3 * shift}});
}

void AddRibs(SceneModel& model) {
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    Mesh ribs;
    for (int i = 4 * chunk; i < std::min(4 * chunk + 4, kWindows + 1); ++i) {
      ribs.Append(Rib(kWindowFirst + i * kWindowPitch - 0.06, 0.37 * i));
    }
    for (const double side : {-1.0, 1.0}) {  // a rail under the windows
      const double low = 1.7 + 2.8 * chunk;
      ribs.Append(Tube({{low, 1.105 * side, 0.06}, {low + 2.8, 1.105 * side, 0.06}}, 0.018, 6,
                       {0.5, {0.1, 0.2}}));
    }
    model.Add("bus_ribs", "panel", std::move(ribs));
  }
  Mesh lights;  // shallow lamps on the ceiling, off the aisle's middle
  for (int i = 0; i < 5; ++i) {
    lights.Append(Box({2.9 + 1.5 * i, i % 2 == 0 ? 0.55 : -0.55, 1.31}, {0.32, 0.12, 0.04},
                      {1.0, {0.3 * i, 0.1}}));
  }
  model.Add("bus_ceiling_lamps", "glass", std::move(lights));
}

Mesh SteeringWheel() {
  std::vector<Vector3d> ring;
  for (int k = 0; k <= 20; ++k) {
    ring.emplace_back(0.22 * std::cos(2 * kPi * k / 20), 0.22 * std::sin(2 * kPi * k / 20), 0.0);
  }
  Mesh wheel = Tube(ring, 0.016, 6, {0.5, {0.1, 0.1}});
  for (const double angle : {0.3, 2.4, 4.5}) {
    wheel.Append(Tube({{0, 0, -0.03}, {0.21 * std::cos(angle), 0.21 * std::sin(angle), 0.0}}, 0.012,
                      5, {0.5, {0.4, 0.1}}));
  }
  wheel.Append(Tube({{0, 0, 0.02}, {0, 0, -0.55}}, 0.03, 8, {0.5, {0.2, 0.4}}));
  return wheel;
}

void AddDriversPlace(SceneModel& model) {
  Mesh dash;
  dash.Append(Box({10.27, 0, -0.02}, {0.26, 2.16, 0.34}, {1.0, {0.2, 0.6}}, 0.06, 1));
  dash.Append(
      Box({10.2, 0.0, -0.40}, {0.36, 0.7, 0.4}, {1.0, {0.7, 0.1}}, 0.08, 1));  // engine cover
  dash.Append(Box({10.12, 0.68, 0.08}, {0.1, 0.5, 0.16}, {1.0, {0.4, 0.3}}, 0.03, 1));
  model.Add("bus_dashboard", "black_paint", std::move(dash));
  Mesh wheel = SteeringWheel();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(-0.75, Vector3d::UnitY()).toRotationMatrix();
  pose.translation() = Vector3d(9.86, 0.70, 0.03);
  wheel.Transform(pose);
  model.Add("bus_steering_wheel", "rubber", std::move(wheel));
  Mesh lever =
      Tube({{9.75, 0.4, kFloor}, {9.9, 0.42, -0.2}, {9.84, 0.42, -0.08}}, 0.012, 6, {0.5, {0, 0}});
  Mesh knob = Rock({0.05, 0.05, 0.05}, 2, 0.0, 1, {0.5, {0, 0}});
  for (Vector3d& p : knob.positions) p += Vector3d(9.84, 0.42, -0.06);
  lever.Append(knob);
  // The bar by the entry steps, and the guard panels behind driver and steps.
  lever.Append(Tube({{9.4, -0.50, kFloor}, {9.4, -0.50, 0.25}, {9.4, -1.1, 0.25}}, 0.018, 6,
                    {0.5, {0.3, 0}}));
  model.Add("bus_levers", "bare_rust", std::move(lever));
  Mesh guards;
  guards.Append(Box({9.25, -0.80, -0.15}, {0.03, 0.60, 0.62}, {1.0, {0.2, 0.1}}));
  guards.Append(Box({9.05, 0.80, -0.05}, {0.03, 0.60, 0.80}, {1.0, {0.7, 0.4}}));
  model.Add("bus_guards", "panel", std::move(guards));
}

}  // namespace

void AddInterior(SceneModel& model, std::uint64_t seed) {
  AddFloor(model, seed);
  AddRibs(model);
  AddDriversPlace(model);
}

}  // namespace drydock::scenes::bus
