#include "scenes/mesh/slab.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::scenes {
namespace {
using Eigen::Vector3d;
using PointFunction = std::function<Vector3d(double, double)>;
using UvFunction = std::function<Eigen::Vector2d(const Vector3d&)>;

/// Builds one wall's meshes cell by cell.
class SlabBuilder {
 public:
  explicit SlabBuilder(const SlabPlan& plan) : plan_(plan) {}

  void AddColumn(int i) {
    for (int j = 0; j + 1 < static_cast<int>(plan_.v_lines.size()); ++j) {
      if (!IsSolid(i, j)) continue;
      AddFace(i, j, plan_.outer, plan_.outer_uv, false, outer_vertices_, meshes_.outer);
      AddFace(i, j, plan_.inner, plan_.inner_uv, true, inner_vertices_, meshes_.inner);
      AddEdges(i, j);
    }
  }

  SlabMeshes Finish() {
    meshes_.outer.ComputeSmoothNormals();
    meshes_.inner.ComputeSmoothNormals();
    meshes_.outer.Append(edges_);
    return std::move(meshes_);
  }

 private:
  using Corner = std::pair<int, int>;

  bool IsSolid(int i, int j) const {
    const bool inside = i >= 0 && j >= 0 && i + 1 < static_cast<int>(plan_.u_lines.size()) &&
                        j + 1 < static_cast<int>(plan_.v_lines.size());
    return inside && !plan_.is_hole(i, j);
  }

  Vector3d At(const PointFunction& point, Corner c) const {
    return point(plan_.u_lines[c.first], plan_.v_lines[c.second]);
  }

  void AddFace(int i, int j, const PointFunction& point, const UvFunction& uv, bool flip,
               std::map<Corner, int>& vertices, Mesh& mesh) {
    const auto vertex = [&](int di, int dj) {
      const Corner corner(i + di, j + dj);
      const auto [found, added] = vertices.try_emplace(corner, 0);
      if (added) {
        const Vector3d p = At(point, corner);
        found->second = mesh.AddVertex(p, Vector3d::Zero(), uv(p));
      }
      return found->second;
    };
    const int a = vertex(0, 0);
    const int b = flip ? vertex(0, 1) : vertex(1, 0);
    const int c = vertex(1, 1);
    const int d = flip ? vertex(1, 0) : vertex(0, 1);
    mesh.AddTriangle(a, b, c);
    mesh.AddTriangle(a, c, d);
  }

  void AddEdges(int i, int j) {
    if (!IsSolid(i, j - 1)) AddEdge({i, j}, {i + 1, j}, {0, -1});
    if (!IsSolid(i + 1, j)) AddEdge({i + 1, j}, {i + 1, j + 1}, {1, 0});
    if (!IsSolid(i, j + 1)) AddEdge({i + 1, j + 1}, {i, j + 1}, {0, 1});
    if (!IsSolid(i - 1, j)) AddEdge({i, j + 1}, {i, j}, {-1, 0});
  }

  /// The edge from a to b, the cell on its left, the hole in direction `out` of the grid.
  void AddEdge(Corner a, Corner b, std::pair<int, int> out) {
    const Vector3d outer_a = At(plan_.outer, a);
    const Vector3d outer_b = At(plan_.outer, b);
    const Vector3d inner_a = At(plan_.inner, a);
    const Vector3d inner_b = At(plan_.inner, b);
    const double du = 1e-3 * out.first;
    const double dv = 1e-3 * out.second;
    const Vector3d nudged =
        plan_.outer(plan_.u_lines[a.first] + du, plan_.v_lines[a.second] + dv) - outer_a;
    const Vector3d into_hole = nudged.normalized() * (inner_a - outer_a).norm();
    edges_.AddQuad({outer_a, inner_a, inner_b, outer_b},
                   {plan_.outer_uv(outer_a), plan_.outer_uv(outer_a + into_hole),
                    plan_.outer_uv(outer_b + into_hole), plan_.outer_uv(outer_b)});
  }

  const SlabPlan& plan_;
  SlabMeshes meshes_;
  Mesh edges_;
  std::map<Corner, int> outer_vertices_;
  std::map<Corner, int> inner_vertices_;
};

}  // namespace

SlabMeshes BuildSlab(const SlabPlan& plan, int first_column, int end_column) {
  Check(plan.u_lines.size() >= 2 && plan.v_lines.size() >= 2, "a wall needs cells");
  SlabBuilder builder(plan);
  for (int i = first_column; i < end_column; ++i) builder.AddColumn(i);
  return builder.Finish();
}

SlabMeshes BuildSlab(const SlabPlan& plan) {
  return BuildSlab(plan, 0, static_cast<int>(plan.u_lines.size()) - 1);
}

std::vector<double> WithSteps(std::vector<double> lines, double step) {
  std::sort(lines.begin(), lines.end());
  std::vector<double> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0 && lines[i] - lines[i - 1] < 1e-9) continue;
    if (i > 0) {
      const double gap = lines[i] - lines[i - 1];
      const int pieces = static_cast<int>(std::ceil(gap / step));
      for (int k = 1; k < pieces; ++k) all.push_back(lines[i - 1] + gap * k / pieces);
    }
    all.push_back(lines[i]);
  }
  return all;
}

}  // namespace drydock::scenes
