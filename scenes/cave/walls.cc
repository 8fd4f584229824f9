#include "scenes/cave/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/utility.hpp>

#include "scenes/cave/painting.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/surface_net.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCell = 0.135;      // [m]
constexpr double kChunk = 3.0;       // [m]
constexpr std::size_t kFewest = 24;  // Triangles that are worth a geom of their own.

using ChunkIndex = std::array<int, 3>;

ChunkIndex ChunkAt(const Vector3d& p) {
  return {static_cast<int>(std::floor(p.x() / kChunk)),
          static_cast<int>(std::floor(p.y() / kChunk)),
          static_cast<int>(std::floor(p.z() / kChunk))};
}

// Layers of the painting, and their labels.
constexpr std::size_t kAxisLayer = 0;      // x, y, z: what the surface is looked along.
constexpr std::size_t kMaterialLayer = 1;  // In kMaterials.
constexpr std::array kMaterials = {"rock_pale",  "rock_bedded",  "rock_sponge", "rock_stained",
                                   "rock_crust", "rock_ceiling", "rock_dusted"};
enum Material { kPale, kBedded, kSponge, kStained, kCrust, kCeiling, kDusted };

void PaintAxes(Painting& painting, std::uint64_t key) {
  const auto jittered = [key](const Vector3d& p, const Vector3d& normal) -> Vector3d {
    const Vector3d jitter(Noise3(p / 0.7, key + 6), Noise3(p / 0.7, key + 7),
                          Noise3(p / 0.7, key + 8));
    return (normal + 0.2 * jitter).cwiseAbs();
  };
  painting.Repaint(kAxisLayer, 0, 2, [&](const Vector3d& p, const Vector3d& normal) {
    const Vector3d n = jittered(p, normal);
    return n.z() - std::max(n.x(), n.y());
  });
  painting.Repaint(kAxisLayer, 0, 1, [&](const Vector3d& p, const Vector3d& normal) {
    const Vector3d n = jittered(p, normal);
    return n.y() - n.x();
  });
}

/// Kinds of rock change over metres, with wavy borders.
void PaintMaterials(Painting& painting, std::uint64_t key) {
  const auto kind = [key](const Vector3d& p, double size, std::uint64_t k) {
    return Fbm3(p / size, 2, key + k) + 0.14 * Fbm3(p / 0.5, 2, key + k + 40);
  };
  painting.Repaint(kMaterialLayer, kPale, kDusted, [&](const Vector3d& p, const Vector3d& n) {
    return n.z() - 0.74 - 0.3 * kind(p, 2.6, 4);
  });
  painting.Repaint(kMaterialLayer, kPale, kCeiling, [&](const Vector3d& p, const Vector3d& n) {
    return -n.z() - 0.5 + 0.5 * kind(p, 2.6, 4);
  });
  painting.Repaint(kMaterialLayer, kPale, kStained,
                   [&](const Vector3d& p, const Vector3d&) { return kind(p, 3.2, 5) - 0.10; });
  painting.Repaint(kMaterialLayer, kStained, kCrust,
                   [&](const Vector3d& p, const Vector3d&) { return kind(p, 2.4, 12); });
  painting.Repaint(kMaterialLayer, kPale, kBedded,
                   [&](const Vector3d& p, const Vector3d&) { return kind(p, 2.8, 14) - 0.06; });
  painting.Repaint(kMaterialLayer, kPale, kSponge,
                   [&](const Vector3d& p, const Vector3d&) { return -0.10 - kind(p, 2.8, 14); });
}

/// Twice the axis, plus one if `normal` points against it: the one that was painted, unless the
/// triangle, on a sharp edge, is seen from its side there.
int AxisOf(const Vector3d& normal, int painted) {
  int axis = painted;
  if (std::abs(normal[axis]) < 0.4 * normal.norm()) normal.cwiseAbs().maxCoeff(&axis);
  return 2 * axis + (normal[axis] < 0.0 ? 1 : 0);
}

/// A chunk's triangles of one picture.
struct Patch {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> axes;  ///< one a triangle
};
using Chunk = std::map<std::string, Patch>;

void Move(const Patch& from, Patch& to) {
  to.triangles.insert(to.triangles.end(), from.triangles.begin(), from.triangles.end());
  to.axes.insert(to.axes.end(), from.axes.begin(), from.axes.end());
}

/// What is too small for a geom goes to the largest patch of the chunk.
void MergeSmall(Chunk& chunk) {
  const auto size = [](const auto& entry) { return entry.second.triangles.size(); };
  const auto largest = std::max_element(
      chunk.begin(), chunk.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
  for (auto it = chunk.begin(); it != chunk.end();) {
    if (it == largest || size(*it) >= kFewest) {
      ++it;
      continue;
    }
    Move(it->second, largest->second);
    it = chunk.erase(it);
  }
}

std::size_t SizeOf(const Chunk& chunk) {
  std::size_t size = 0;
  for (const auto& [material, patch] : chunk) size += patch.triangles.size();
  return size;
}

/// Chunks of a few triangles, where the surface just touches a cell, go to the largest beside them.
void MergeSmall(std::map<ChunkIndex, Chunk>& chunks) {
  for (auto it = chunks.begin(); it != chunks.end();) {
    auto best = chunks.end();
    for (int side = 0; side < 6 && SizeOf(it->second) < kFewest; ++side) {
      ChunkIndex index = it->first;
      index[side / 2] += side % 2 == 0 ? 1 : -1;
      const auto beside = chunks.find(index);
      if (beside == chunks.end()) continue;
      if (best == chunks.end() || SizeOf(beside->second) > SizeOf(best->second)) best = beside;
    }
    if (best == chunks.end()) {
      ++it;
      continue;
    }
    for (auto& [material, patch] : it->second) Move(patch, best->second[material]);
    it = chunks.erase(it);
  }
}

Mesh MeshOf(const Patch& patch, const Mesh& surface, std::uint64_t key) {
  Mesh mesh;
  std::map<std::pair<int, int>, int> places;  // of vertex and axis
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    std::array<int, 3> triangle = patch.triangles[i];
    for (int& corner : triangle) {
      const auto [place, is_new] = places.try_emplace({corner, patch.axes[i]}, 0);
      if (is_new) {
        const Vector3d& p = surface.positions[corner];
        place->second = mesh.AddVertex(p, surface.normals[corner], RockUv(p, patch.axes[i], key));
      }
      corner = place->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

Mesh RockSurface(const RockField& rock) {
  FieldGrid grid(BoundsOf(rock.plan(), 1.6), kCell);
  // Every value depends on its place alone, so threads change nothing.
  cv::parallel_for_(cv::Range(0, grid.counts()[2]), [&](const cv::Range& range) {
    for (int k = range.start; k < range.end; ++k)
      grid.FillLayer(k, [&](const Vector3d& p) { return rock.At(p); });
  });
  return LargestPiece(SurfaceNet(grid));
}

Vector2d RockUv(const Vector3d& p, int axis, std::uint64_t key) {
  const Vector3d bend(0.9 * Fbm3(p / 3.7, 2, key + 9), 0.9 * Fbm3(p / 3.7, 2, key + 10),
                      0.35 * Fbm3(p / 3.7, 2, key + 11));
  const Vector3d q = (p + bend) / kRockTile;
  const Vector2d shift(0.31 * axis, 0.17 * axis);
  const double side = axis % 2 == 0 ? 1.0 : -1.0;
  if (axis / 2 == 0) return shift + Vector2d(side * q.y(), -q.z());
  if (axis / 2 == 1) return shift + Vector2d(-side * q.x(), -q.z());
  return shift + Vector2d(side * q.x(), -q.y());
}

void AddWalls(SceneModel& model, Mesh surface, const SandFloor& sand, std::uint64_t seed) {
  const std::uint64_t key = RandomStream(seed, "cave/walls").BitsAt(0);
  constexpr double kHidden = 0.12;  // The sand's triangles stay within that of its height [m].
  surface.Erase([&sand](const Vector3d& p) {
    return p.z() < 0.0 && p.z() < sand.Height(p.x(), p.y()) - kHidden;
  });
  Painting painting(std::move(surface), 2);
  PaintAxes(painting, key);
  PaintMaterials(painting, key);
  const Mesh& mesh = painting.mesh();
  std::map<ChunkIndex, Chunk> chunks;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<int, 3>& t = mesh.triangles[i];
    const Vector3d& a = mesh.positions[t[0]];
    const Vector3d& b = mesh.positions[t[1]];
    const Vector3d& c = mesh.positions[t[2]];
    const int axis = AxisOf((b - a).cross(c - a), painting.LabelOf(kAxisLayer, i));
    Patch& patch =
        chunks[ChunkAt((a + b + c) / 3.0)][kMaterials.at(painting.LabelOf(kMaterialLayer, i))];
    patch.triangles.push_back(t);
    patch.axes.push_back(axis);
  }
  MergeSmall(chunks);
  for (auto& [index, chunk] : chunks) {
    MergeSmall(chunk);
    for (const auto& [material, patch] : chunk) {
      // Fewer are a crumb that just looks out of the sand, and no mesh that MuJoCo takes.
      if (patch.triangles.size() < 4) continue;
      model.Add("cave", material, MeshOf(patch, mesh, key));
    }
  }
}

}  // namespace drydock::scenes::cave
