// The body's shell.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

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

std::string SideName(Side side) { return side == Side::kLeft ? "left" : "right"; }

/// Dents in the side's panels, none where they meet other parts.
double Dent(const Vector3d& p, std::uint64_t key) {
  const auto ease = [](double d, double over) { return std::clamp(d / over, 0.0, 1.0); };
  const double inside = ease(p.x() - kSideRear, 0.5) * ease(kSideFront - p.x(), 0.5) *
                        ease(kEave - p.z(), 0.3) * ease(p.z() - kSkirt, 0.1);
  return 0.03 * inside * Fbm2({0.9 * p.x(), 1.2 * p.z()}, 3, key);
}

/// A point of the left wall; `inset` from the outside.
Vector3d SidePoint(double x, double v, double inset, std::uint64_t key) {
  const double bottom = SkirtBottom(x);
  const double z = v >= kRail ? v : bottom + (v - kSkirt) / (kRail - kSkirt) * (kRail - bottom);
  // The front end leans with the windscreen.
  const double end = FrontX(kHalfWidth, z) - kSideFront;
  const double lean = end * std::clamp((x - 9.6) / (kSideFront - 9.6), 0.0, 1.0);
  Vector3d p(x + lean, kHalfWidth - inset, z);
  p.y() += Dent(p, key);
  return p;
}

std::vector<double> SideLines(Side side) {
  std::vector<double> lines = {kSideRear, kSideFront};
  for (int i = 0; i < kWindows; ++i) {
    lines.push_back(kWindowFirst + i * kWindowPitch);
    lines.push_back(kWindowFirst + i * kWindowPitch + kWindowWidth);
  }
  const double* door = side == Side::kLeft ? kDriverWindow : kEntryDoor;
  lines.insert(lines.end(), {door[0], door[1]});
  for (int k = 0; k <= 10; ++k) {
    lines.push_back(kRearAxle + kArchRadius * std::cos(std::numbers::pi * k / 10));
  }
  return WithSteps(lines, 0.4);
}

/// One side, built as the left one and mirrored for the right.
void AddSide(SceneModel& model, Side side, std::uint64_t key) {
  const bool mirrored = side == Side::kRight;
  SlabPlan plan;
  // Seen from the left, the outside is where (-x) x z points: the lines run backwards.
  std::vector<double> lines = SideLines(side);
  for (double& x : lines) x = -x;
  std::sort(lines.begin(), lines.end());
  plan.u_lines = lines;
  plan.v_lines = WithSteps({kSkirt, kRail, kSill, kHead, kEntryDoorTop, kEave}, 0.35);
  plan.is_hole = [&plan, side](int i, int j) {
    return IsSideOpening(side, -0.5 * (plan.u_lines[i] + plan.u_lines[i + 1]),
                         0.5 * (plan.v_lines[j] + plan.v_lines[j + 1]));
  };
  plan.outer = [key](double u, double v) { return SidePoint(-u, v, 0.0, key); };
  plan.inner = [key](double u, double v) { return SidePoint(-u, v, kWall, key); };
  plan.outer_uv = [side](const Vector3d& p) { return SideUv(side, p); };
  plan.inner_uv = [side](const Vector3d& p) { return InsideUv(side, p); };
  const int columns = static_cast<int>(lines.size()) - 1;
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    SlabMeshes meshes = BuildSlab(plan, columns * chunk / kChunks, columns * (chunk + 1) / kChunks);
    if (mirrored) meshes.outer.MirrorY();
    if (mirrored) meshes.inner.MirrorY();
    model.Add("bus_side_" + SideName(side), "side_" + SideName(side), std::move(meshes.outer));
    model.Add("bus_wall_" + SideName(side), "inside_" + SideName(side), std::move(meshes.inner));
  }
}

/// The roof from outside (inset 0) or the ceiling.
void AddRoof(SceneModel& model, bool ceiling) {
  const double half_width = kHalfWidth - (ceiling ? kWall : 0.0);
  const double rise = ceiling ? kCeilingRise : kRoofRise;
  const int cells = static_cast<int>(RoofLines().size()) - 1;
  std::vector<Vector3d> section;
  for (const double y : RoofLines())
    section.emplace_back(0.0, y * half_width, rise * RoofFraction(y));
  const std::vector<double> arc = ArcFractions(section);
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    Mesh mesh = GridSheet(8, cells, [&](double s, double t) -> SurfacePoint {
      const auto line = static_cast<std::size_t>(std::lround(t * cells));
      const double y = half_width * RoofLines()[line];
      const double rear = RearX(y * kHalfWidth / half_width) + (ceiling ? kWall : 0.0);
      const double front = FrontX(y * kHalfWidth / half_width, kEave) - (ceiling ? kWall : 0.0);
      const double along = (chunk + s) / kChunks;
      // More lines near the ends, where the roof comes down.
      const double eased = along + 0.10 * std::sin(2 * std::numbers::pi * (along - 0.5));
      const double x = rear + (front - rear) * eased;
      const double end = std::min(x - rear, front - x);
      const double z = kEave + rise * EndFactor(end) * RoofFraction(y / half_width);
      const Vector2d uv((x - kRoofCanvas.left) / kRoofCanvas.width, 1.0 - arc[line]);
      return {{x, y, z}, uv};
    });
    if (ceiling) mesh = Flipped(mesh);
    model.Add(ceiling ? "bus_ceiling" : "bus_roof", ceiling ? "ceiling" : "roof", std::move(mesh));
  }
}

std::vector<double> EndLines(std::vector<double> lines) {
  for (const double y : RoofLines()) lines.push_back(y * kHalfWidth);
  for (const double y : {1.05, 1.11, 1.16, 1.19}) {
    lines.push_back(y);
    lines.push_back(-y);
  }
  return WithSteps(lines, 0.5);
}

/// Upper part of an end wall: squeezed under the roof's curve.
double EndHeight(double y, double v) {
  if (v <= kHead) return v;
  const double top = kEave + kRoofRise * kEndRise * RoofFraction(y / kHalfWidth);
  return kHead + (v - kHead) / (kEave + kRoofRise * kEndRise - kHead) * (top - kHead);
}

void AddRear(SceneModel& model) {
  SlabPlan plan;
  plan.u_lines = EndLines(
      {-kHalfWidth, kHalfWidth, -kBackDoorHalfWidth, kBackDoorHalfWidth, -0.98, -0.66, 0.66, 0.98});
  plan.v_lines = WithSteps(
      {kSkirt, kFloor, kSill, 0.72, kHead, kBackDoorTop, kEave + kRoofRise * kEndRise}, 0.4);
  plan.is_hole = [&plan](int i, int j) {
    const double y = std::abs(0.5 * (plan.u_lines[i] + plan.u_lines[i + 1]));
    const double z = 0.5 * (plan.v_lines[j] + plan.v_lines[j + 1]);
    const bool door = y < kBackDoorHalfWidth && z > kFloor && z < kBackDoorTop;
    const bool window = y > 0.66 && y < 0.98 && z > kSill && z < 0.72;
    return door || window;
  };
  plan.outer = [](double u, double v) -> Vector3d { return {RearX(u), -u, EndHeight(u, v)}; };
  plan.inner = [](double u, double v) -> Vector3d {
    const double shrink = (kHalfWidth - kWall) / kHalfWidth;
    return {RearX(u) + kWall, -u * shrink, EndHeight(u, v)};
  };
  plan.outer_uv = RearUv;
  plan.inner_uv = [](const Vector3d& p) -> Vector2d { return {p.y() / 2.0, -p.z() / 2.0}; };
  SlabMeshes meshes = BuildSlab(plan);
  model.Add("bus_rear", "rear", std::move(meshes.outer));
  model.Add("bus_rear_inside", "panel", std::move(meshes.inner));
}

void AddFront(SceneModel& model) {
  SlabPlan plan;
  plan.u_lines = EndLines({-kHalfWidth, kHalfWidth, -kScreenHalfWidth, kScreenHalfWidth});
  plan.v_lines =
      WithSteps({kSkirt, kScreenFoot, kHead, kScreenTop, kEave + kRoofRise * kEndRise}, 0.4);
  plan.is_hole = [&plan](int i, int j) {
    const double y = std::abs(0.5 * (plan.u_lines[i] + plan.u_lines[i + 1]));
    const double z = 0.5 * (plan.v_lines[j] + plan.v_lines[j + 1]);
    return y < kScreenHalfWidth && z > kScreenFoot && z < kScreenTop;
  };
  plan.outer = [](double u, double v) -> Vector3d {
    const double z = EndHeight(u, v);
    return {FrontX(u, z), u, z};
  };
  plan.inner = [](double u, double v) -> Vector3d {
    const double shrink = (kHalfWidth - kWall) / kHalfWidth;
    const double z = EndHeight(u, v);
    return {FrontX(u, z) - kWall, u * shrink, z};
  };
  plan.outer_uv = FrontUv;
  plan.inner_uv = [](const Vector3d& p) -> Vector2d { return {p.y() / 2.0, -p.z() / 2.0}; };
  SlabMeshes meshes = BuildSlab(plan);
  model.Add("bus_front", "front", std::move(meshes.outer));
  model.Add("bus_front_inside", "panel", std::move(meshes.inner));
}

/// Black rub rails along the sides, interrupted by the entry door.
void AddRails(SceneModel& model, Side side) {
  const double y = (kHalfWidth + 0.012) * (side == Side::kLeft ? 1.0 : -1.0);
  const double end = side == Side::kLeft ? kSideFront : kEntryDoor[0];
  double shift = side == Side::kLeft ? 0.1 : 0.55;
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    const double low = kSideRear + (end - kSideRear) * chunk / kChunks;
    const double high = kSideRear + (end - kSideRear) * (chunk + 1) / kChunks;
    Mesh rails;
    for (const double z : {kRail, -0.12, kSill - 0.05}) {
      shift += 0.31;
      rails.Append(Box({0.5 * (low + high), y, z}, {high - low, 0.045, z < -0.2 ? 0.10 : 0.075},
                       {1.0, {shift, shift}}, 0.012, 0));
    }
    model.Add("bus_rail_" + SideName(side), "black_paint", std::move(rails));
  }
}

/// What is left in one window: the middle bar of most, a dirty pane or half a pane in some.
void AppendWindow(Mesh& bars, Mesh& panes, double x, double y, RandomStream& random) {
  const double middle = x + 0.5 * kWindowWidth;
  const double state = random.Uniform();
  const double bar = 0.5 * (kSill + kHead) + (state < 0.15 ? -0.12 : 0.0);
  const double shift_u = random.Uniform();
  const Vector2d shift(shift_u, random.Uniform());
  const auto pane = [&](double low, double high, const Vector2d& offset) {
    return Box({middle, y, 0.5 * (low + high)}, {kWindowWidth, 0.012, high - low}, {1.0, offset});
  };
  if (state < 0.85) {
    bars.Append(Box({middle, y, bar}, {kWindowWidth, 0.035, 0.035}, {1.0, shift}));
  }
  if (state < 0.30) panes.Append(pane(kSill, bar, shift));
  if (state < 0.12 || (state > 0.30 && state < 0.5)) {
    panes.Append(pane(bar, kHead, shift + Vector2d(0.3, 0.4)));
  }
}

void AddWindows(SceneModel& model, Side side, RandomStream& random) {
  const double y = (kHalfWidth - 0.035) * (side == Side::kLeft ? 1.0 : -1.0);
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    Mesh bars;
    Mesh panes;
    for (int i = kWindows * chunk / kChunks; i < kWindows * (chunk + 1) / kChunks; ++i) {
      AppendWindow(bars, panes, kWindowFirst + i * kWindowPitch, y, random);
    }
    model.Add("bus_window_bars_" + SideName(side), "black_paint", std::move(bars));
    model.Add("bus_window_panes_" + SideName(side), "glass", std::move(panes));
  }
}

}  // namespace

void AddBody(SceneModel& model, std::uint64_t seed) {
  RandomStream random(seed, "bus/windows");
  for (const Side side : {Side::kLeft, Side::kRight}) {
    AddSide(model, side, RandomStream(seed, "bus/dents_" + SideName(side)).BitsAt(0));
    AddRails(model, side);
    AddWindows(model, side, random);
  }
  AddRoof(model, false);
  AddRoof(model, true);
  AddRear(model);
  AddFront(model);
}

}  // namespace drydock::scenes::bus
