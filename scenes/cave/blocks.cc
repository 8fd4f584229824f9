#include "scenes/cave/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "scenes/cave/ground.h"
#include "scenes/mesh/lattice_noise.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A plane that cuts the block off, over its distance: v . p = 1.
std::vector<Vector3d> CutsOf(const Vector3d& half, int corners, RandomStream& random) {
  const auto jitter = [&random](double amount) -> Vector3d {
    const double x = random.Gaussian();
    const double y = random.Gaussian();
    return amount * Vector3d(x, y, random.Gaussian());
  };
  std::vector<Vector3d> cuts;
  for (int face = 0; face < 6; ++face) {
    Vector3d normal = Vector3d::Zero();
    normal[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    normal = (normal + jitter(0.13)).normalized();
    cuts.push_back(normal / (half[face / 2] * random.Uniform(0.85, 1.15)));
  }
  // Corners broken off.
  for (int i = 0; i < corners; ++i) {
    const Vector3d normal = (jitter(1.0) + Vector3d(0, 0, 0.3)).normalized();
    const double to_corner = normal.cwiseAbs().dot(half);
    cuts.emplace_back(normal / (to_corner * random.Uniform(0.5, 0.8)));
  }
  return cuts;
}

/// How far the block reaches along a direction; its edges are rounded a little.
double Reach(const std::vector<Vector3d>& cuts, const Vector3d& direction) {
  double sum = 0.0;
  for (const Vector3d& cut : cuts) {
    const double x = std::max(cut.dot(direction), 0.0);
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double x8 = x4 * x4;
    sum += x8 * x8 * x8;
  }
  return 1.0 / std::cbrt(std::sqrt(std::sqrt(std::sqrt(sum))));
}

/// Each triangle with the picture as it is seen along the axis that it faces most, so that nothing
/// is drawn out.
Mesh WithPicture(const Mesh& mesh, const Vector2d& shift) {
  Mesh mapped;
  std::map<std::pair<int, int>, int> places;  // of vertex and axis
  for (std::array<int, 3> t : mesh.triangles) {
    const Vector3d& a = mesh.positions[t[0]];
    const Vector3d normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    for (int& corner : t) {
      const auto [place, is_new] = places.try_emplace({corner, axis}, 0);
      if (is_new) {
        const Vector3d& p = mesh.positions[corner];
        const Vector2d uv = Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]) / kBlockTile;
        place->second = mapped.AddVertex(p, mesh.normals[corner], uv + (1 + axis) * shift);
      }
      corner = place->second;
    }
    mapped.triangles.push_back(t);
  }
  return mapped;
}

}  // namespace

Mesh MakeBlock(double size, RandomStream& random) {
  const double wide = random.Uniform(0.55, 0.95);
  const double high = random.Uniform(0.35, 0.75);
  const std::vector<Vector3d> cuts =
      CutsOf(0.5 * size * Vector3d(1.0, wide, high), size > 0.5 ? 5 : 11, random);
  const std::uint64_t key = random.Bits();
  const double shift = random.Uniform();
  const int cells = size > 1.1 ? 9 : size > 0.6 ? 7 : size > 0.25 ? 4 : 3;
  const double quarter_turn = 0.5 * std::numbers::pi;
  const auto surface = [&](const Vector3d& direction) -> Vector3d {
    const Vector3d p = Reach(cuts, direction) * direction;
    // Bedding shows on its sides, the rest is rough.
    const double bed = 0.05 * Noise3({0.3, 0.7, 9.0 * p.z() / size}, key + 5);
    return p + (bed + 0.07 * Fbm3(4.0 * p / size, 3, key)) * size * direction;
  };
  Mesh mesh;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    mesh.Append(GridSheet(cells, cells, [&](double s, double t) -> SurfacePoint {
      Vector3d cube;
      cube[axis] = sign;
      cube[(axis + 1) % 3] = sign * std::tan((s - 0.5) * quarter_turn);
      cube[(axis + 2) % 3] = std::tan((t - 0.5) * quarter_turn);
      return {surface(cube.normalized()), Vector2d::Zero()};
    }));
  }
  return WithPicture(mesh, {shift, 0.61 * shift});
}

Mesh MakeStalactite(double length, RandomStream& random) {
  constexpr int kRows = 10;
  constexpr int kSegments = 10;
  constexpr double kRoot = 0.3;
  const double radius = 0.05 + 0.13 * length * random.Uniform(0.7, 1.3);
  const std::uint64_t key = random.Bits();
  std::vector<Vector2d> profile = {{0.0, -length}};
  for (int i = 0; i <= kRows; ++i) {
    const double up = static_cast<double>(i) / kRows;
    const double rings = 1.0 + 0.22 * Noise2({9.0 * up * length, 0.5}, key);
    const double foot = 1.0 + 0.9 * std::pow(up, 8);
    profile.emplace_back(radius * (0.10 + 0.90 * std::pow(up, 1.15)) * rings * foot,
                         -length * (1.0 - up) + 0.012);
  }
  profile.emplace_back(2.1 * radius, kRoot);
  profile.emplace_back(0.0, kRoot + 0.01);
  Mesh mesh = Lathe(profile, kSegments, 1.0, (length + kRoot) / kDripstoneTile, 0.0);
  for (Vector3d& p : mesh.positions) {
    const Vector3d n = p / 0.16;
    const double flutes = 0.28 * Noise3({n.x(), n.y(), 0.25 * n.z()}, key + 1);
    p.head<2>() *= 1.0 + flutes + 0.12 * Noise3(p / 0.06, key + 2);
    p.x() += 0.10 * radius * Noise2({p.z() / 0.5, 0.1}, key + 3);
    p.y() += 0.10 * radius * Noise2({p.z() / 0.5, 0.6}, key + 4);
  }
  mesh.ComputeSmoothNormals();
  return mesh;
}

}  // namespace drydock::scenes::cave
