#include "scenes/cemetery/growth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scenes/mesh/shapes.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cemetery {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;

UvRect PlantColumn(int first, int count, RandomStream& random) {
  const double column = first + std::floor(random.Uniform(0.0, count));
  return {{(column + 0.08) / kPlantColumns, 0.02}, {(column + 0.92) / kPlantColumns, 0.98}};
}

Vector2d Scatter(const Vector2d& middle, double spread, RandomStream& random) {
  const double x = std::clamp(random.Gaussian(), -2.0, 2.0);
  return middle + spread * Vector2d(x, std::clamp(random.Gaussian(), -2.0, 2.0));
}

Vector2d Direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A random place in the square of graves and around it, the likelier the nearer to the way.
Vector2d RandomPlace(RandomStream& random) {
  while (true) {
    const double x = random.Uniform(kWest - 5.0, kEast + 5.0);
    const Vector2d p(x, random.Uniform(kSouth - 5.0, kNorth + 5.0));
    if (random.Uniform() < std::exp2(-DistanceToWay(p) / 1.3)) return p;
  }
}

/// A blade of water weed from the ground up, bent over.
Mesh Blade(const Vector3d& root, double height, const Vector2d& bend, RandomStream& random) {
  const double turn = random.Uniform(0.0, kTurn);
  const Vector3d side(std::cos(turn), std::sin(turn), 0.0);
  const double width = random.Uniform(0.006, 0.013);
  const double wave = 0.05 * height * random.Uniform(-1.0, 1.0);
  std::vector<Vector3d> spine;
  std::vector<double> widths;
  const int steps = height > 0.25 ? 3 : 2;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Vector2d over = t * t * bend;
    // What bends over comes up less high.
    const double up = height * t - 0.35 * over.norm() * t;
    spine.push_back(root + Vector3d(over.x(), over.y(), up) + wave * std::sin(5.0 * t) * side);
    widths.push_back(width * (k == steps ? 0.12 : 1.0 - 0.25 * t));
  }
  return Ribbon(spine, widths, side, PlantColumn(0, kBladeColumns, random));
}

struct Patch {
  double spread;  ///< [m]
  double height;  ///< [m]
  int tufts;
};

/// Tufts of blades that spread from a common root and lean with the current.
Mesh Tufts(const Ground& ground, const Vector2d& middle, const Patch& patch, double current,
           RandomStream& random) {
  constexpr int kBlades = 7;
  Mesh weed;
  for (int i = 0; i < patch.tufts; ++i) {
    const Vector2d root = Scatter(middle, patch.spread, random);
    const double tuft = patch.height * random.Uniform(0.6, 1.0);
    for (int k = 0; k < kBlades; ++k) {
      const Vector2d p = Scatter(root, 0.025, random);
      const double z = ground.Height(p) - 0.03;
      const double height = std::min(tuft, CeilingAt(p) - z) * random.Uniform(0.45, 1.0);
      const double away = random.Uniform(0.0, kTurn);
      const Vector2d bend =
          height * (random.Uniform(0.1, 0.6) * Direction(away) + 0.25 * Direction(current));
      weed.Append(Blade({p.x(), p.y(), z}, height, bend, random));
    }
  }
  return weed;
}

/// Broad leaves in a ring, near the ground.
Mesh Rosette(const Ground& ground, const Vector2d& p, RandomStream& random) {
  Mesh plant;
  const double reach = random.Uniform(0.12, 0.26);
  const Vector3d root(p.x(), p.y(), ground.Height(p) - 0.01);
  const int leaves = 9;
  for (int i = 0; i < leaves; ++i) {
    const double angle = kTurn * i / leaves + random.Uniform(-0.3, 0.3);
    const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    const double rise = random.Uniform(0.3, 0.8) * reach;
    const std::vector<Vector3d> spine = {root, root + 0.5 * reach * out + Vector3d(0, 0, rise),
                                         root + reach * out + Vector3d(0, 0, 0.7 * rise)};
    plant.Append(Ribbon(spine, {0.06 * reach, 0.15 * reach, 0.02 * reach}, {-out.y(), out.x(), 0.0},
                        PlantColumn(0, kBladeColumns, random)));
  }
  return plant;
}

/// A dead leaf, curled, on the ground. Seen from above alone.
Mesh DeadLeaf(const Ground& ground, const Vector2d& p, RandomStream& random) {
  const double length = random.Uniform(0.06, 0.15);
  const double angle = random.Uniform(0.0, kTurn);
  const Vector2d along = Direction(angle);
  const Vector2d across(-along.y(), along.x());
  const double curl = random.Uniform(0.05, 0.3) * length;
  const double lift = random.Uniform(0.004, 0.02);
  const UvRect picture = PlantColumn(kBladeColumns, kPlantColumns - kBladeColumns, random);
  const double half_widths[] = {0.05, 0.27, 0.02};
  return GridSheet(2, 2, [&](double s, double t) -> SurfacePoint {
    const auto row = static_cast<std::size_t>(std::lround(2.0 * t));
    const double u = 2.0 * s - 1.0;
    const Vector2d q = p + (t - 0.5) * length * along - u * half_widths[row] * length * across;
    const double z =
        ground.Height(q) + lift + curl * u * u + 0.5 * curl * (2 * t - 1) * (2 * t - 1);
    return {{q.x(), q.y(), z}, picture.At(s, 1.0 - t)};
  });
}

/// Drops what lies below the silt and is never seen.
void DropBuried(Mesh& mesh, const Ground& ground) {
  mesh.Erase([&](const Vector3d& p) { return p.z() < ground.Height(p.head<2>()) - 0.03; });
}

Mesh Pebble(const Ground& ground, const Vector2d& p, double size, int cells, RandomStream& random) {
  const double y = random.Uniform(0.7, 1.0);
  const Vector3d extent(size, size * y, size * random.Uniform(0.45, 0.8));
  const std::uint64_t key = random.Bits();
  const double u = random.Uniform();
  Mesh pebble = Rock(extent, cells, 0.35, key, {1.2, {u, random.Uniform()}});
  pebble.Transform(Eigen::Translation3d(p.x(), p.y(), ground.Height(p) + 0.12 * size) *
                   Eigen::AngleAxisd(random.Uniform(0.0, kTurn), Vector3d::UnitZ()));
  return pebble;
}

void AddWeed(SceneModel& model, const Ground& ground, const std::vector<Grave>& graves,
             std::uint64_t seed) {
  RandomStream random(seed, "cemetery/weed");
  const double current = random.Uniform(0.0, kTurn);
  int number = 0;
  const auto add = [&](const Vector2d& middle, const Patch& patch) {
    model.Add(fmt::format("weed_{:02}", number++), "plants",
              Tufts(ground, middle, patch, current, random));
  };
  for (const Grave& grave : graves) {  // It grows where the silt is not stirred: behind stones.
    const Vector2d middle = Scatter(grave.foot, 0.22, random);
    const double height = random.Uniform(0.25, 0.65);
    const bool grows = random.Uniform() < 0.45;
    if (grows && DistanceToWay(grave.foot) < 4.0) add(middle, {0.17, height, 4});
  }
  for (int i = 0; i < 46; ++i) {
    const Vector2d middle = RandomPlace(random);
    const double height = 0.2 + 0.6 * random.Uniform() * random.Uniform();
    add(middle, {random.Uniform(0.12, 0.32), height, 5});
  }
  for (int i = 0; i < 26; ++i) {
    const Vector2d middle = RandomPlace(random);
    Mesh plants;
    for (int k = 0; k < 3; ++k) {
      plants.Append(Rosette(ground, Scatter(middle, 0.3, random), random));
    }
    model.Add(fmt::format("rosettes_{:02}", i), "plants", std::move(plants));
  }
}

void AddLeaves(SceneModel& model, const Ground& ground, std::uint64_t seed) {
  RandomStream random(seed, "cemetery/leaves");
  for (int i = 0; i < 46; ++i) {
    const Vector2d middle = RandomPlace(random);
    Mesh leaves;
    for (int k = 0; k < 14; ++k) {
      leaves.Append(DeadLeaf(ground, Scatter(middle, 0.45, random), random));
    }
    model.Add(fmt::format("leaves_{:02}", i), "plants", std::move(leaves));
  }
}

void AddStones(SceneModel& model, const Ground& ground, std::uint64_t seed) {
  RandomStream random(seed, "cemetery/rubble");
  for (int i = 0; i < 24; ++i) {
    const Vector2d middle = RandomPlace(random);
    Mesh pebbles;
    for (int k = 0; k < 6; ++k) {
      const double u = random.Uniform();
      const Vector2d p = Scatter(middle, 0.4, random);
      pebbles.Append(Pebble(ground, p, 0.05 + 0.12 * u * u, u > 0.6 ? 3 : 2, random));
    }
    DropBuried(pebbles, ground);
    model.Add(fmt::format("pebbles_{:02}", i), i % 3 == 0 ? "limestone" : "slate",
              std::move(pebbles));
  }
  for (int i = 0; i < 30; ++i) {
    const Vector2d p = RandomPlace(random);
    Mesh rock = Pebble(ground, p, random.Uniform(0.16, 0.42), 3, random);
    DropBuried(rock, ground);
    model.Add(fmt::format("rock_{:02}", i), "slate", std::move(rock));
  }
  for (int i = 0; i < 24; ++i) {
    const Vector2d p = RandomPlace(random);
    Object shard = MakeShard(random.Uniform(0.22, 0.5), random);
    const double yaw = random.Uniform(0.0, kTurn);
    const double tip = 0.25 * random.Gaussian();
    for (auto& [material, mesh] : shard) {
      mesh.Transform(Eigen::Translation3d(p.x(), p.y(), ground.Height(p) + 0.01) *
                     Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(std::clamp(tip, -0.5, 0.5), Vector3d::UnitX()));
      model.Add(fmt::format("shard_{:02}", i), material, std::move(mesh));
    }
  }
}

std::vector<Vector3d> CrookedLine(const Vector3d& from, const Vector3d& along, int steps,
                                  RandomStream& random) {
  std::vector<Vector3d> line = {from};
  Vector3d bend = Vector3d::Zero();
  for (int i = 1; i <= steps; ++i) {
    const double aside = random.Gaussian();
    bend += 0.05 * along.norm() * Vector3d(0.0, aside, 0.3 * random.Gaussian());
    line.push_back(from + along * i / steps + bend);
  }
  return line;
}

/// A tube that grows thinner towards its end.
Mesh Limb(const std::vector<Vector3d>& line, double radius, int segments, RandomStream& random) {
  std::vector<double> radii;
  radii.reserve(line.size());
  for (const double t : ArcFractions(line)) radii.push_back(radius * (1.0 - 0.7 * t));
  const double u = random.Uniform();
  return Tube(line, radii, segments, {0.5, {u, random.Uniform()}});
}

/// A limb of a dead tree with some twigs, lying where it sank, along x.
Mesh Branch(double length, RandomStream& random) {
  constexpr int kSteps = 7;
  const std::vector<Vector3d> line =
      CrookedLine({-0.5 * length, 0.0, 0.02}, {length, 0.0, 0.06}, kSteps, random);
  Mesh branch = Limb(line, 0.028 * length, 6, random);
  for (int i = 2; i < kSteps; ++i) {
    const double reach = length * random.Uniform(0.18, 0.4);
    const double side = i % 2 == 0 ? 0.8 : -0.8;
    const Vector3d out(0.6 * reach, side * reach, random.Uniform(0.0, 0.5) * reach);
    branch.Append(Limb(CrookedLine(line[i], out, 4, random), 0.010 * length, 4, random));
  }
  return branch;
}

void AddBranches(SceneModel& model, const Ground& ground, std::uint64_t seed) {
  RandomStream random(seed, "cemetery/branches");
  for (int i = 0; i < 9; ++i) {
    const Vector2d p = RandomPlace(random);
    Mesh branch = Branch(random.Uniform(0.7, 1.6), random);
    const double yaw = random.Uniform(0.0, kTurn);
    branch.Transform(Eigen::Translation3d(p.x(), p.y(), ground.Height(p)) *
                     Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
    for (Vector3d& q : branch.positions) q.z() = std::min(q.z(), CeilingAt(q.head<2>()));
    model.Add(fmt::format("branch_{:02}", i), "bark", std::move(branch));
  }
}

}  // namespace

void AddGrowth(SceneModel& model, const Ground& ground, const std::vector<Grave>& graves,
               std::uint64_t seed) {
  AddWeed(model, ground, graves, seed);
  AddLeaves(model, ground, seed);
  AddStones(model, ground, seed);
  AddBranches(model, ground, seed);
}

}  // namespace drydock::scenes::cemetery
