#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "scenes/cave/blocks.h"
#include "scenes/cave/ground.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

bool IsClear(const Route& route, const Mesh& mesh) {
  const double clear = kCorridorRadius + 0.03;
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const Vector3d& p) {
    return route.IsFarther(p, clear) || route.Distance(p) > clear;
  });
}

/// Moved to its place; shorter than asked for where the corridor is near, empty where that does not
/// help. `turned`: standing on the ground.
Mesh Hang(const RockField& rock, const Vector3d& root, double length, bool turned,
          RandomStream& random) {
  for (; length > 0.15; length *= 0.7) {
    Mesh mesh = MakeStalactite(length, random);
    Eigen::Isometry3d pose(Eigen::Translation3d{root});
    if (turned) pose.rotate(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()));
    mesh.Transform(pose);
    if (IsClear(rock.route(), mesh)) return mesh;
  }
  return {};
}

Mesh Cluster(const RockField& rock, const SandFloor& sand, const DripstoneSpot& spot,
             RandomStream& random) {
  Mesh all;
  for (int i = 0; i < spot.count; ++i) {
    const double angle = random.Uniform(0.0, 2.0 * std::numbers::pi);
    const double out = spot.radius * std::sqrt(random.Uniform());
    const double length = spot.longest * (0.3 + 0.7 * std::pow(random.Uniform(), 1.5));
    const bool has_partner = random.Uniform() < 0.3;
    const Vector2d p = spot.center + out * Vector2d(std::cos(angle), std::sin(angle));
    const Vector3d middle(p.x(), p.y(), 0.4);
    if (rock.At(middle) < 0.3) continue;
    const double ceiling = rock.CeilingOver(middle, 5.0);
    all.Append(Hang(rock, {p.x(), p.y(), ceiling - 0.02}, length, false, random));
    if (!has_partner) continue;
    const double floor = std::max(rock.BottomUnder(middle, 3.0), sand.Height(p.x(), p.y()));
    all.Append(Hang(rock, {p.x(), p.y(), floor + 0.02}, 0.6 * length, true, random));
  }
  return all;
}

}  // namespace

void AddDripstone(SceneModel& model, const RockField& rock, const SandFloor& sand,
                  std::uint64_t seed) {
  RandomStream random(seed, "cave/dripstone");
  for (std::size_t i = 0; i < rock.plan().dripstone.size(); ++i) {
    model.Add(fmt::format("dripstone_{}", i), "dripstone",
              Cluster(rock, sand, rock.plan().dripstone[i], random));
  }
}

}  // namespace drydock::scenes::cave
