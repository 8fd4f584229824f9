#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scenes/cave/blocks.h"
#include "scenes/cave/ground.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Puts blocks where they leave the corridor free, and leaves out what of them nobody sees.
class Mason {
 public:
  Mason(SceneModel& model, const RockField& rock, const SandFloor& sand)
      : model_(model), rock_(rock), sand_(sand) {}

  double SandAt(const Vector2d& p) const { return sand_.Height(p.x(), p.y()); }
  double OpenAt(const Vector2d& p) const { return rock_.Open({p.x(), p.y(), SandAt(p) + 0.25}); }

  /// The block at its place; an empty mesh where it would reach into the corridor or is buried.
  Mesh Place(Mesh block, const Vector3d& center, RandomStream& random, double tip) const {
    const double yaw = random.Uniform(0.0, kTurn);
    const double tip_x = tip * random.Gaussian();
    const double tip_y = tip * random.Gaussian();
    block.Transform(Eigen::Translation3d(center) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tip_x, Vector3d::UnitX()) *
                    Eigen::AngleAxisd(tip_y, Vector3d::UnitY()));
    if (!IsClear(block)) return {};
    block.Erase([this](const Vector3d& p) {
      return p.z() < sand_.Height(p.x(), p.y()) - 0.05 || rock_.At(p) < -0.18;
    });
    constexpr std::size_t kFewest = 8;  // Triangles that are seen.
    return block.triangles.size() < kFewest ? Mesh() : block;
  }

  void Add(const std::string& body, Mesh mesh) { model_.Add(body, "rock_broken", std::move(mesh)); }

 private:
  bool IsClear(const Mesh& mesh) const {
    const double clear = kCorridorRadius + 0.03;
    return std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const Vector3d& p) {
      return rock_.route().IsFarther(p, clear) || rock_.route().Distance(p) > clear;
    });
  }

  SceneModel& model_;
  const RockField& rock_;
  const SandFloor& sand_;
};

/// Large blocks at the bottom, smaller ones farther up.
void AddHeap(Mason& mason, const Heap& heap, const std::string& name, RandomStream& random) {
  const Eigen::Rotation2Dd turn(heap.yaw_rad);
  for (int i = 0; i < heap.blocks; ++i) {
    const double up = (i + random.Uniform()) / heap.blocks;
    const double size = heap.radii.y() * (0.95 - 0.45 * up) * random.Uniform(0.6, 1.1);
    const double angle = random.Uniform(0.0, kTurn);
    const double out = std::sqrt(random.Uniform(0.0, 1.0 - 0.9 * up));
    const Vector2d reach = heap.radii.head<2>() - Vector2d::Constant(0.45 * size);
    const Vector2d p = heap.center + turn * Vector2d(out * reach.x() * std::cos(angle),
                                                     out * reach.y() * std::sin(angle));
    const double top = heap.radii.z() * (1.0 - out * out);
    const double z = mason.SandAt(p) + 0.12 * size + (0.5 + 0.5 * up) * std::max(top - size, 0.0);
    mason.Add(fmt::format("{}_{:02}", name, i),
              mason.Place(MakeBlock(size, random), {p.x(), p.y(), z}, random, 0.35));
  }
}

/// A place on the sand whose distance from the walls is likely small.
Vector2d FindPlace(const Mason& mason, const Eigen::AlignedBox3d& box, double reach,
                   RandomStream& random) {
  Vector2d p = Vector2d::Zero();
  for (int attempt = 0; attempt < 300; ++attempt) {
    const double x = random.Uniform(box.min().x(), box.max().x());
    p = {x, random.Uniform(box.min().y(), box.max().y())};
    const double keep = random.Uniform();
    const double open = mason.OpenAt(p);
    if (open > -0.1 && keep < std::exp2(-open / reach)) break;
  }
  return p;
}

void ScatterBlocks(Mason& mason, const CavePlan& plan, std::uint64_t seed) {
  RandomStream random(seed, "cave/blocks");
  const Eigen::AlignedBox3d box = BoundsOf(plan, 0.0);
  for (int i = 0; i < plan.scattered_blocks; ++i) {
    const double size = 0.45 + 1.2 * std::pow(random.Uniform(), 2);
    const Vector2d p = FindPlace(mason, box, 0.5, random);
    const Vector3d center(p.x(), p.y(), mason.SandAt(p) + 0.12 * size);
    mason.Add(fmt::format("block_{:02}", i),
              mason.Place(MakeBlock(size, random), center, random, 0.2));
  }
}

/// Too many for a geom each: those of a patch of floor are one.
void ScatterStones(Mason& mason, const CavePlan& plan, std::uint64_t seed) {
  RandomStream random(seed, "cave/stones");
  const Eigen::AlignedBox3d box = BoundsOf(plan, 0.0);
  std::map<std::pair<int, int>, Mesh> patches;
  for (int i = 0; i < plan.scattered_stones; ++i) {
    const Vector2d p = FindPlace(mason, box, 1.1, random);
    const int company = static_cast<int>(random.Uniform(1.0, 3.0));
    for (int k = 0; k < company; ++k) {
      const double dx = 0.35 * random.Gaussian();
      const Vector2d q = k == 0 ? p : Vector2d(p + Vector2d(dx, 0.35 * random.Gaussian()));
      const double size = 0.07 + 0.36 * std::pow(random.Uniform(), 3);
      Mesh stone = mason.Place(MakeBlock(size, random),
                               {q.x(), q.y(), mason.SandAt(q) + 0.1 * size}, random, 0.3);
      patches[{static_cast<int>(std::floor(q.x() / 3.0)),
               static_cast<int>(std::floor(q.y() / 3.0))}]
          .Append(stone);
    }
  }
  int number = 0;
  for (auto& [place, patch] : patches)
    mason.Add(fmt::format("stones_{:02}", number++), std::move(patch));
}

}  // namespace

void AddBreakdown(SceneModel& model, const RockField& rock, const SandFloor& sand,
                  std::uint64_t seed) {
  Mason mason(model, rock, sand);
  RandomStream heaps(seed, "cave/heaps");
  for (std::size_t i = 0; i < rock.plan().heaps.size(); ++i)
    AddHeap(mason, rock.plan().heaps[i], fmt::format("heap_{}", i), heaps);
  ScatterBlocks(mason, rock.plan(), seed);
  ScatterStones(mason, rock.plan(), seed);
}

}  // namespace drydock::scenes::cave
