#include "scenes/bus/clutter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scenes/bus/bus_shape.h"
#include "scenes/bus/debris.h"
#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::bus {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;

/// Free space beside the way for things that reach up to it [m].
constexpr double kClearance = 1.05;

/// How a thing lies.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
  double sunk = 0.05;  ///< into the bed
  double tip_x = 0.0;
  double tip_y = 0.0;
  double radius = 0.5;  ///< kept free of random things
};

/// What may stand where.
struct Demand {
  double radius = 0.3;
  double height = 0.3;
  double reach = 2.5;    ///< the likelihood halves with each such distance from the way
  double spacing = 0.9;  ///< relative to the sum of the radii
};

/// Puts things on the lake bed and remembers where.
class Placer {
 public:
  Placer(SceneModel& model, const LakeBed& bed, const Corridor& corridor)
      : model_(model), bed_(bed), corridor_(corridor) {}

  double BedHeight(double x, double y) const { return bed_.Height(x, y); }

  /// Drops what lies well below the bed and is never seen. (The bed's triangles stay within the
  /// margin of its true height.)
  void DropBuried(Mesh& mesh) const {
    mesh.Erase([this](const Vector3d& p) { return p.z() < bed_.Height(p.x(), p.y()) - 0.04; });
  }

  void Put(const std::string& name, Object object, const Pose& pose) {
    PlaceObject(object, {pose.x, pose.y, bed_.Height(pose.x, pose.y) - pose.sunk}, pose.yaw,
                pose.tip_x, pose.tip_y);
    for (auto& [material, mesh] : object) {
      DropBuried(mesh);
      model_.Add(name, material, std::move(mesh));
    }
    taken_.emplace_back(pose.x, pose.y, pose.radius);
  }

  /// A random free spot, more likely near the way; none if there is hardly room.
  std::optional<Vector2d> Find(const Demand& demand, RandomStream& random) const {
    for (int attempt = 0; attempt < 400; ++attempt) {
      const double x = random.Uniform(-13.0, 25.0);
      const double y = random.Uniform(-21.0, 15.0);
      const double distance = corridor_.HorizontalDistance(x, y);
      if (random.Uniform() > std::exp2(-distance / demand.reach)) continue;
      if (IsFree(x, y, demand)) return Vector2d(x, y);
    }
    return std::nullopt;
  }

 private:
  bool IsFree(double x, double y, const Demand& demand) const {
    if (DistanceToBus(x, y) < demand.radius + 0.15) return false;
    const double gap = demand.height > 0.55 ? kClearance : -0.2;
    if (corridor_.HorizontalDistance(x, y) < demand.radius + gap) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Vector3d& t) {
      return std::hypot(t.x() - x, t.y() - y) < demand.spacing * (demand.radius + t.z());
    });
  }

  SceneModel& model_;
  const LakeBed& bed_;
  const Corridor& corridor_;
  std::vector<Vector3d> taken_;  ///< x, y, radius
};

// The things that make each stretch of the way unlike the others, placed by hand.

void AddLandmarksLeft(Placer& placer, RandomStream& random) {
  placer.Put("tree_0", MakeTree(5.6, random), {5.2, 3.3, 0.18, 0.05, 0, 0, 1.5});
  placer.Put("stump_0", MakeStump(random), {9.4, 2.3, 0.4, 0.05, 0.05, 0.1, 0.8});
  placer.Put("tyre_0", MakeTyre(random), {2.2, 1.95, 0.3, 0.02, 0.35, 0.1, 0.4});
  placer.Put("barrel_0", MakeBarrel(random), {12.4, 2.0, 0.2, 0.2, 0.12, 0.1, 0.35});
  placer.Put("barrel_1", MakeBarrel(random), {13.4, 2.6, 1.2, -0.22, 0, 1.5, 0.6});
  placer.Put("pallet_0", MakePallet(random), {7.6, 2.3, 0.2, 0.0, 0.5, 0.0, 0.7});
  placer.Put("crate_2", MakeCrate(random), {10.9, 1.9, 0.3, 0.06, 0.1, 0.1, 0.45});
  placer.Put("pile_7", MakePile(2.3, 0.13, random), {3.1, 2.0, 0, 0.1, 0.08, 0.05, 0.3});
  placer.Put("pile_11", MakePile(1.7, 0.12, random), {8.3, 2.9, 0, 0.1, -0.15, 0.1, 0.3});
}

void AddLandmarksFront(Placer& placer, RandomStream& random) {
  // The piles of an old jetty, and what hung on it.
  const double piles[][3] = {{16.0, 1.4, 2.6},  {16.6, 0.1, 3.4},  {17.9, -2.2, 3.6},
                             {18.2, -4.4, 3.3}, {16.3, -6.0, 3.2}, {15.0, 3.0, 2.4},
                             {18.6, 2.2, 2.7}};
  int number = 0;
  for (const auto& p : piles) {
    Pose pose{p[0], p[1], 0.0, 0.1, 0.0, 0.0, 0.3};
    pose.tip_x = 0.08 * random.Gaussian();
    pose.tip_y = 0.08 * random.Gaussian();
    placer.Put(fmt::format("pile_{}", number++), MakePile(p[2], 0.15, random), pose);
  }
  placer.Put("deck_0", MakeDeck(4.1, 4.6, random), {15.6, -2.9, 0.06, 0.15, 0.07, -1.02, 1.6});
  placer.Put("log_1", MakeLog(3.6, 0.13, random), {16.3, 0.9, 1.3, -0.5, 0.0, 0.22, 0.6});
  placer.Put("crate_0", MakeCrate(random), {15.5, -5.4, 0.5, 0.08, 0.1, 0.2, 0.5});
  placer.Put("tyre_1", MakeTyre(random), {15.6, -4.2, 0.0, -0.1, 1.1, 0.0, 0.4});
  placer.Put("tree_1", MakeTree(5.0, random), {19.0, -8.6, 2.2, 0.05, 0.2, 0, 1.5});
}

/// A branch that drifted onto the hood, flat enough to pass above it.
void AddBranchOnHood(SceneModel& model, RandomStream& random) {
  Object branch = MakeTree(5.0, random);
  for (auto& [material, mesh] : branch) {
    for (Vector3d& p : mesh.positions) p = p.cwiseProduct(Vector3d(0.5, 0.5, 0.22));
  }
  PlaceObject(branch, {11.85, kBusY + 0.1, 0.13}, 1.35);
  for (auto& [material, mesh] : branch) model.Add("branch_on_hood", material, std::move(mesh));
}

void AddLandmarksRight(Placer& placer, RandomStream& random) {
  placer.Put("pipe_0", MakePipe(2.2, 0.45, random), {13.6, -9.0, 0.7, 0.08, 0, 0, 1.1});
  placer.Put("boat_0", MakeBoat(random), {6.6, -9.8, 0.35, 0.1, 0.38, 0.05, 1.6});
  placer.Put("barrel_2", MakeBarrel(random), {10.2, -8.6, 0.3, -0.22, 0, 1.55, 0.6});
  placer.Put("crate_1", MakeCrate(random), {3.2, -8.5, 0.9, 0.05, 0, 0.15, 0.5});
  placer.Put("tyre_2", MakeTyre(random), {11.6, -8.4, 0.3, -0.02, 0.4, 0.0, 0.4});
  placer.Put("tree_2", MakeTree(5.2, random), {0.2, -10.0, 0.4, 0.05, 0, 0, 1.5});
  placer.Put("pile_12", MakePile(2.4, 0.14, random), {9.0, -8.9, 0, 0.1, 0.1, -0.1, 0.3});
  placer.Put("pile_13", MakePile(2.0, 0.14, random), {4.3, -8.3, 0, 0.1, -0.06, 0.12, 0.3});
}

void AddLandmarksBehind(Placer& placer, RandomStream& random) {
  placer.Put("stump_1", MakeStump(random), {-3.3, -6.9, 1.0, 0.05, 0.1, 0.0, 0.8});
  placer.Put("barrel_3", MakeBarrel(random), {-3.4, -1.9, 0.1, 0.2, -0.15, 0.1, 0.35});
  placer.Put("barrel_4", MakeBarrel(random), {-4.1, -2.6, 0.8, -0.2, 0, 1.5, 0.6});
  placer.Put("log_3", MakeLog(3.8, 0.26, random), {-4.6, -4.6, 1.3, 0.1, 0, 0, 1.4});
  placer.Put("pile_8", MakePile(2.6, 0.14, random), {-4.9, -8.2, 0.0, 0.1, 0.1, 0.0, 0.3});
  placer.Put("pile_9", MakePile(2.1, 0.14, random), {-3.9, -9.9, 0.0, 0.1, -0.1, 0.1, 0.3});
  placer.Put("pile_10", MakePile(2.8, 0.14, random), {-4.6, 0.6, 0.0, 0.1, 0.05, -0.1, 0.3});
}

void AddBoulders(Placer& placer, RandomStream& random) {
  const double spots[][3] = {
      {-1.8, 3.0, 1.5},  {1.0, 3.6, 1.8},   {8.0, 4.3, 1.7},    {11.3, 3.7, 1.7},
      {14.9, 1.3, 1.2},  {17.6, -2.6, 1.9}, {16.2, -8.0, 1.6},  {12.0, -10.6, 1.9},
      {8.9, -10.8, 1.5}, {4.0, -10.6, 1.7}, {-2.0, -8.6, 1.5},  {-5.6, -6.4, 1.8},
      {-5.7, -1.8, 1.7}, {-3.6, 2.0, 1.6},  {15.0, -10.6, 2.2}, {18.6, 0.4, 2.1},
      {-3.2, -4.6, 0.9}, {13.0, 4.2, 2.0},  {6.6, 5.0, 2.0},    {1.6, -8.9, 1.2}};
  int number = 0;
  for (const auto& spot : spots) {
    Object boulder = MakeBoulder(spot[2], 5, random);
    Pose pose{spot[0], spot[1], random.Uniform(0, kTurn), 0.08 * spot[2], 0.0, 0.0, 0.5 * spot[2]};
    placer.Put(fmt::format("boulder_{:02}", number++), std::move(boulder), pose);
  }
}

void AddDrownedTrees(Placer& placer, RandomStream& random) {
  const double spots[][3] = {{3.0, 3.0, 4.2},   {8.7, 3.3, 3.6},   {13.4, 3.8, 4.4},
                             {17.8, 1.3, 4.0},  {17.4, -6.6, 4.6}, {15.3, -8.8, 3.8},
                             {10.2, -9.9, 4.4}, {2.0, -9.8, 4.0},  {-3.4, -8.6, 3.6},
                             {-4.3, -3.6, 4.2}, {-3.2, 2.6, 3.8}};
  int number = 0;
  for (const auto& spot : spots) {
    Object tree = MakeDrownedTree(spot[2], random);
    Pose pose{spot[0], spot[1], random.Uniform(0, kTurn), 0.0, 0.0, 0.0, 0.5};
    pose.tip_x = 0.05 * random.Gaussian();
    placer.Put(fmt::format("drowned_tree_{}", number++), std::move(tree), pose);
  }
}

void AddBlocks(Placer& placer, RandomStream& random) {
  const Vector2d spots[] = {{2.6, 1.9},  {5.9, 1.7},   {10.2, 1.5}, {14.9, -6.9},
                            {4.4, -7.9}, {-2.6, -5.6}, {8.4, -8.2}};
  int number = 0;
  for (const Vector2d& spot : spots) {
    Pose pose{spot.x(), spot.y(), random.Uniform(0, kTurn), 0.03, 0.0, 0.0, 0.25};
    pose.tip_x = 0.3 * random.Gaussian();
    pose.tip_y = 0.2 * random.Gaussian();
    placer.Put(fmt::format("block_{}", number++), MakeBlock(random), pose);
  }
}

/// An old farm fence, from before the valley was flooded: spans from point to point.
void AddFence(Placer& placer, const std::string& name, const std::vector<Vector2d>& line,
              RandomStream& random) {
  int number = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d along = line[i + 1] - line[i];
    const int spans = std::max(1, static_cast<int>(std::lround(along.norm() / 1.5)));
    for (int k = 0; k < spans; ++k) {
      const Vector2d p = line[i] + along * (static_cast<double>(k) / spans);
      const Vector2d q = line[i] + along * (static_cast<double>(k + 1) / spans);
      if (random.Uniform() < 0.12) continue;  // a gap
      const double rise = placer.BedHeight(q.x(), q.y()) - placer.BedHeight(p.x(), p.y());
      Pose pose{p.x(), p.y(), std::atan2(along.y(), along.x()), 0.0, 0.0, 0.0, 0.3};
      pose.tip_x = 0.07 * random.Gaussian();
      pose.tip_y = -std::atan2(rise, (q - p).norm());
      placer.Put(fmt::format("{}_{:02}", name, number++), MakeFenceSpan((q - p).norm(), random),
                 pose);
    }
  }
}

struct Scatter {
  const char* name;
  int count;
  double low, high;  ///< sizes [m]
  int cells;
  double reach;
  double spacing;
};

void ScatterRocks(Placer& placer, RandomStream& random) {
  const Scatter sizes[] = {{"big_rock", 14, 0.9, 1.7, 4, 3.5, 1.0},
                           {"rock", 52, 0.3, 0.8, 3, 2.4, 0.85},
                           {"stone", 64, 0.14, 0.3, 2, 1.8, 0.7}};
  for (const Scatter& scatter : sizes) {
    for (int i = 0; i < scatter.count; ++i) {
      const double size =
          scatter.low + (scatter.high - scatter.low) * std::pow(random.Uniform(), 1.6);
      const auto spot =
          placer.Find({0.6 * size, 0.75 * size, scatter.reach, scatter.spacing}, random);
      if (!spot) continue;
      Object rock = MakeBoulder(size, scatter.cells, random);
      Pose pose{spot->x(), spot->y(), random.Uniform(0, kTurn), 0.10 * size, 0.0, 0.0, 0.55 * size};
      pose.tip_x = 0.15 * random.Gaussian();
      pose.tip_y = 0.15 * random.Gaussian();
      placer.Put(fmt::format("{}_{:03}", scatter.name, i), std::move(rock), pose);
    }
  }
}

/// Pebbles: too many for a geom each; a patch is one.
void ScatterPebbles(SceneModel& model, const Placer& placer, RandomStream& random) {
  for (int patch = 0; patch < 10; ++patch) {
    const auto middle = placer.Find({0.3, 0.1, 1.6, 0.0}, random);
    if (!middle) continue;
    Mesh pebbles;
    for (int i = 0; i < 9; ++i) {
      const double x = middle->x() + 0.8 * random.Gaussian();
      const double y = middle->y() + 0.8 * random.Gaussian();
      const double size = random.Uniform(0.05, 0.14);
      Object pebble = MakeBoulder(size, 2, random);
      PlaceObject(pebble, {x, y, placer.BedHeight(x, y) - 0.1 * size}, random.Uniform(0, kTurn));
      pebbles.Append(pebble.front().second);
    }
    placer.DropBuried(pebbles);
    model.Add(fmt::format("pebbles_{:02}", patch), "stone", std::move(pebbles));
  }
}

void ScatterWeeds(Placer& placer, RandomStream& random) {
  for (int i = 0; i < 52; ++i) {
    const double height = 0.45 + 1.6 * random.Uniform() * random.Uniform();
    const auto spot = placer.Find({0.2 + 0.3 * height, height, 2.4, 0.3}, random);
    if (!spot) continue;
    placer.Put(fmt::format("weeds_{:02}", i), MakeWeeds(height, 10, random),
               {spot->x(), spot->y(), 0, 0, 0, 0, 0.2});
  }
  for (int i = 0; i < 26; ++i) {  // low tufts may stand under the way
    const auto spot = placer.Find({0.15, 0.3, 1.6, 0.2}, random);
    if (!spot) continue;
    placer.Put(fmt::format("grass_{:02}", i), MakeWeeds(0.34, 8, random),
               {spot->x(), spot->y(), 0, 0, 0, 0, 0.1});
  }
}

void ScatterLitter(Placer& placer, RandomStream& random) {
  for (int i = 0; i < 6; ++i) {
    const auto spot = placer.Find({0.4, 0.1, 1.0, 0.2}, random);
    if (!spot) continue;
    placer.Put(fmt::format("litter_{}", i), MakeLitter(random),
               {spot->x(), spot->y(), 0, 0.01, 0, 0, 0.1});
  }
}

}  // namespace

void AddClutter(SceneModel& model, const LakeBed& bed, const Corridor& corridor,
                std::uint64_t seed) {
  Placer placer(model, bed, corridor);
  RandomStream landmarks(seed, "bus/landmarks");
  AddLandmarksLeft(placer, landmarks);
  AddLandmarksFront(placer, landmarks);
  AddLandmarksRight(placer, landmarks);
  AddLandmarksBehind(placer, landmarks);
  AddBranchOnHood(model, landmarks);
  RandomStream rocks(seed, "bus/rocks");
  AddBoulders(placer, rocks);
  AddDrownedTrees(placer, landmarks);
  RandomStream fences(seed, "bus/fences");
  AddFence(placer, "fence_left", {{0.2, 1.9}, {3.6, 1.45}, {8.0, 1.5}, {11.6, 1.75}}, fences);
  AddFence(placer, "fence_right", {{12.2, -8.2}, {7.8, -8.05}, {4.6, -8.0}, {1.2, -8.4}}, fences);
  AddFence(placer, "fence_rear", {{-3.0, -0.6}, {-2.9, -3.6}, {-2.7, -6.4}}, fences);
  AddBlocks(placer, rocks);
  ScatterRocks(placer, rocks);
  RandomStream pebbles(seed, "bus/pebbles");
  ScatterPebbles(model, placer, pebbles);
  RandomStream weeds(seed, "bus/weeds");
  ScatterWeeds(placer, weeds);
  RandomStream litter(seed, "bus/litter");
  ScatterLitter(placer, litter);
}

}  // namespace drydock::scenes::bus
