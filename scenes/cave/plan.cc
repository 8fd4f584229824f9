#include "scenes/cave/plan.h"

#include <cmath>
#include <numbers>

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Counter-clockwise part of an ellipse around `center`, from the angle `from` to `to` [rad],
/// measured from its southernmost point.
void AddArc(std::vector<Vector3d>& route, const Vector2d& center, const Vector2d& radii,
            double from, double to, double rise) {
  const int steps = static_cast<int>(std::ceil(std::abs(to - from) * radii.maxCoeff() / 0.35));
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    route.emplace_back(center.x() + radii.x() * std::sin(angle),
                       center.y() - radii.y() * std::cos(angle),
                       0.5 * rise * (1.0 - std::cos(angle)));
  }
}

/// A room with a pillar in a heap of blocks, and the lobes that make its walls uneven.
void AddRoom(CavePlan& plan, const Vector2d& c, double mirror, double pillar) {
  const auto at = [&](double x, double y, double z) {
    return Vector3d(c.x() + mirror * x, c.y() + y, z);
  };
  plan.rooms.push_back({at(0, 0, -0.2), {5.4, 4.6, 3.5}});
  plan.rooms.push_back({at(-4.2, 1.6, -0.3), {2.0, 2.0, 1.8}});
  plan.rooms.push_back({at(1.2, 4.0, 0.1), {2.6, 1.6, 1.9}});
  plan.rooms.push_back({at(-2.2, -3.0, -0.1), {2.2, 1.7, 1.7}});
  plan.rooms.push_back({at(1.6, -1.4, 2.3), {1.7, 1.5, 1.6}});
  plan.rooms.push_back({at(-1.6, 2.2, 2.2), {1.4, 1.6, 1.5}});
  plan.pillars.push_back({c, pillar, 0.7});
}

}  // namespace

CavePlan Cavern1Plan() {
  CavePlan plan;
  plan.name = "cavern1";
  // The hall; alcoves, most of them in the north; domes in the ceiling.
  plan.rooms = {{{0.0, 3.6, -0.3}, {7.9, 5.7, 3.9}},   {{-0.8, 9.4, 0.0}, {2.2, 1.9, 2.0}},
                {{-6.6, 6.6, -0.2}, {2.9, 2.4, 2.0}},  {{-4.0, 9.2, 0.2}, {2.4, 2.0, 2.0}},
                {{-4.4, -1.5, -0.1}, {2.2, 1.3, 1.6}}, {{4.2, -1.2, -0.2}, {2.2, 1.3, 1.6}},
                {{3.6, 2.4, 2.8}, {2.0, 1.8, 1.8}},    {{-4.0, 5.6, 2.5}, {1.9, 2.0, 1.7}},
                {{5.4, 5.2, 2.0}, {1.4, 1.5, 1.6}}};
  // Ways on that are not swum.
  plan.passages = {{{-7.4, 7.2, -0.5}, {-9.8, 8.4, -0.8}, 0.9, 0.8},
                   {{7.2, 2.0, -0.6}, {9.6, 0.8, -0.9}, 0.8, 0.7}};
  plan.pillars = {{{-2.7, 3.5}, 0.80, 0.6},
                  {{-0.6, 3.8}, 0.65, 0.2},
                  {{1.7, 3.6}, 0.95, 0.8},
                  {{2.0, 9.3}, 0.8, 0.3}};
  plan.heaps = {{{-0.3, 3.6}, {4.0, 2.0, 2.3}, 0.03, 44},
                {{7.2, 0.6}, {1.0, 0.8, 0.9}, 0.6, 7},
                {{-7.0, 4.6}, {1.2, 0.9, 1.0}, 2.2, 8},
                {{3.4, 8.6}, {1.2, 0.7, 0.9}, 0.0, 7}};
  plan.dripstone = {{{2.6, -1.5}, 0.9, 9, 0.9},  {{6.9, 4.4}, 0.9, 8, 1.0},
                    {{4.2, 7.6}, 0.9, 9, 0.9},   {{-2.4, 9.2}, 1.0, 9, 1.2},
                    {{-7.2, 3.0}, 0.9, 10, 1.1}, {{-2.2, -1.4}, 0.8, 7, 0.7},
                    {{0.6, 3.5}, 1.6, 12, 1.2},  {{-5.4, 8.2}, 0.8, 5, 0.9}};
  plan.scattered_blocks = 44;
  plan.scattered_stones = 260;
  AddArc(plan.route, {0.0, 3.6}, {5.5, 3.6}, 0.0, kTurn, 0.2);
  return plan;
}

CavePlan Cavern2Plan() {
  constexpr double kApart = 21.0;  // [m], between the rooms' middles, along x
  constexpr double kNorth = 2.3;
  const Vector2d loop(3.0, kNorth);
  const Vector2d turn(kNorth, kNorth);
  CavePlan plan;
  plan.name = "cavern2";
  AddRoom(plan, {0.0, kNorth}, 1.0, 0.55);
  AddRoom(plan, {kApart, kNorth}, -1.0, 0.8);
  plan.rooms.push_back({{22.6, 5.6, 0.4}, {2.2, 2.0, 2.0}});
  plan.passages = {{{4.0, 0.0, 0.05}, {8.2, 0.3, 0.05}, 1.5, 1.35},
                   {{8.2, 0.3, 0.05}, {12.8, -0.3, 0.0}, 1.5, 1.35},
                   {{12.8, -0.3, 0.0}, {17.0, 0.0, 0.0}, 1.5, 1.35},
                   {{23.6, 5.6, -0.6}, {26.0, 8.2, -0.8}, 0.8, 0.8}};
  plan.heaps = {{{0.3, kNorth}, {1.8, 1.25, 1.5}, 0.0, 16},
                {{kApart - 0.2, kNorth + 0.1}, {1.8, 1.25, 1.9}, 0.0, 22},
                {{-3.9, 4.9}, {1.2, 0.9, 1.0}, 2.4, 6},
                {{kApart + 4.0, 0.0}, {0.9, 1.0, 0.9}, 0.9, 6}};
  plan.dripstone = {{{-3.4, -0.8}, 0.8, 7, 0.8},        {{3.4, 5.0}, 0.8, 8, 1.0},
                    {{0.2, kNorth}, 1.1, 8, 0.9},       {{kApart + 1.0, 5.4}, 1.0, 9, 1.1},
                    {{kApart + 3.8, 3.4}, 0.9, 8, 1.0}, {{kApart - 1.5, -1.4}, 0.7, 6, 0.7}};
  plan.scattered_blocks = 40;
  plan.scattered_stones = 260;
  AddArc(plan.route, {0.0, kNorth}, loop, 0.0, kTurn, 0.0);
  plan.route.insert(plan.route.end(),
                    {{4.0, 0.0, 0.0}, {8.0, 0.1, 0.05}, {13.0, -0.1, 0.05}, {17.0, 0.0, 0.0}});
  AddArc(plan.route, {kApart, kNorth}, loop, 0.0, 1.75 * kTurn, 0.0);
  // Out of the room by a turn to the right, into the other one by another.
  AddArc(plan.route, {kApart - loop.x() - turn.x(), kNorth}, turn, 0.25 * kTurn, 0.0, 0.0);
  AddArc(plan.route, {loop.x() + turn.x(), kNorth}, turn, 0.0, -0.25 * kTurn, 0.0);
  return plan;
}

Eigen::AlignedBox3d BoundsOf(const CavePlan& plan, double margin) {
  Eigen::AlignedBox3d box;
  for (const Room& room : plan.rooms) {
    box.extend(Vector3d(room.center - room.radii));
    box.extend(Vector3d(room.center + room.radii));
  }
  for (const Passage& passage : plan.passages) {
    const Vector3d half(passage.half_width, passage.half_width, passage.half_height);
    for (const Vector3d& end : {passage.from, passage.to}) {
      box.extend(Vector3d(end - half));
      box.extend(Vector3d(end + half));
    }
  }
  const Vector3d all = Vector3d::Constant(margin);
  return {box.min() - all, box.max() + all};
}

}  // namespace drydock::scenes::cave
