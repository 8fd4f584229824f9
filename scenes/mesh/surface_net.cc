#include "scenes/mesh/surface_net.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::scenes {
namespace {
using Eigen::Vector3d;

/// Two neighbouring lattice points, of which the second is one further along `axis`.
struct Edge {
  std::array<int, 3> from;
  int axis;
};

/// The twelve edges of the cell between the origin and (1, 1, 1).
std::array<Edge, 12> EdgesOfCell() {
  std::array<Edge, 12> edges = {};
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Edge& edge = edges[count++];
      edge.axis = axis;
      edge.from[(axis + 1) % 3] = corner & 1;
      edge.from[(axis + 2) % 3] = corner >> 1;
    }
  }
  return edges;
}

class NetBuilder {
 public:
  explicit NetBuilder(const FieldGrid& grid) : grid_(grid) {
    const auto& n = grid.counts();
    vertices_.assign(static_cast<std::size_t>(n[0]) * n[1] * n[2], -1);
  }

  Mesh Build() {
    const auto& n = grid_.counts();
    for (int k = 0; k + 1 < n[2]; ++k) {
      for (int j = 0; j + 1 < n[1]; ++j) {
        for (int i = 0; i + 1 < n[0]; ++i) AddVertex({i, j, k});
      }
    }
    for (int k = 0; k + 1 < n[2]; ++k) {
      for (int j = 0; j + 1 < n[1]; ++j) {
        for (int i = 0; i + 1 < n[0]; ++i) {
          for (int axis = 0; axis < 3; ++axis) AddFace({{i, j, k}, axis});
        }
      }
    }
    mesh_.ComputeSmoothNormals();
    return std::move(mesh_);
  }

 private:
  bool IsSolid(const std::array<int, 3>& p) const { return grid_.At(p[0], p[1], p[2]) < 0.F; }

  void AddVertex(const std::array<int, 3>& cell) {
    Vector3d sum = Vector3d::Zero();
    int crossings = 0;
    for (const Edge& edge : edges_) {
      std::array<int, 3> a = cell;
      for (int axis = 0; axis < 3; ++axis) a[axis] += edge.from[axis];
      std::array<int, 3> b = a;
      ++b[edge.axis];
      if (IsSolid(a) == IsSolid(b)) continue;
      const double at_a = grid_.At(a[0], a[1], a[2]);
      const double at_b = grid_.At(b[0], b[1], b[2]);
      Vector3d p = grid_.PointAt(a[0], a[1], a[2]);
      p[edge.axis] += grid_.cell() * at_a / (at_a - at_b);
      sum += p;
      ++crossings;
    }
    if (crossings == 0) return;
    vertices_[grid_.IndexOf(cell[0], cell[1], cell[2])] =
        mesh_.AddVertex(sum / crossings, Vector3d::Zero(), Eigen::Vector2d::Zero());
  }

  /// Joins the vertices of the four cells around an edge that the surface cuts.
  void AddFace(const Edge& edge) {
    const std::array<int, 3>& a = edge.from;
    std::array<int, 3> b = a;
    ++b[edge.axis];
    const int u = (edge.axis + 1) % 3;
    const int v = (edge.axis + 2) % 3;
    if (IsSolid(a) == IsSolid(b) || a[u] == 0 || a[v] == 0) return;
    std::array<int, 4> corners = {};
    for (int corner = 0; corner < 4; ++corner) {
      std::array<int, 3> cell = a;
      if (corner == 0 || corner == 3) --cell[u];
      if (corner < 2) --cell[v];
      corners[corner] = vertices_[grid_.IndexOf(cell[0], cell[1], cell[2])];
    }
    if (IsSolid(b)) std::swap(corners[1], corners[3]);
    AddQuad(corners);
  }

  /// Along the shorter diagonal, so that the triangles are the less slender.
  void AddQuad(const std::array<int, 4>& c) {
    const auto apart = [this](int a, int b) {
      return (mesh_.positions[a] - mesh_.positions[b]).squaredNorm();
    };
    if (apart(c[0], c[2]) <= apart(c[1], c[3])) {
      mesh_.AddTriangle(c[0], c[1], c[2]);
      mesh_.AddTriangle(c[0], c[2], c[3]);
    } else {
      mesh_.AddTriangle(c[0], c[1], c[3]);
      mesh_.AddTriangle(c[1], c[2], c[3]);
    }
  }

  const FieldGrid& grid_;
  const std::array<Edge, 12> edges_ = EdgesOfCell();
  std::vector<int> vertices_;  ///< of the cell above each lattice point; -1 for none
  Mesh mesh_;
};

}  // namespace

FieldGrid::FieldGrid(const Eigen::AlignedBox3d& box, double cell) : low_(box.min()), cell_(cell) {
  Check(cell > 0.0 && !box.isEmpty(), "a lattice needs a box and a cell, not {} m", cell);
  for (int axis = 0; axis < 3; ++axis)
    counts_[axis] = static_cast<int>(std::ceil(box.sizes()[axis] / cell - 1e-9)) + 1;
  values_.resize(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2]);
}

void FieldGrid::FillLayer(int k, const std::function<double(const Vector3d&)>& field) {
  for (int j = 0; j < counts_[1]; ++j) {
    for (int i = 0; i < counts_[0]; ++i)
      values_[IndexOf(i, j, k)] = static_cast<float>(field(PointAt(i, j, k)));
  }
}

void FieldGrid::Fill(const std::function<double(const Vector3d&)>& field) {
  for (int k = 0; k < counts_[2]; ++k) FillLayer(k, field);
}

Mesh SurfaceNet(const FieldGrid& grid) { return NetBuilder(grid).Build(); }

Mesh LargestPiece(const Mesh& mesh) {
  // Each vertex points to one of its piece, the piece's first one to itself.
  std::vector<int> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto first_of = [&parent](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : mesh.triangles) {
    parent[first_of(t[1])] = first_of(t[0]);
    parent[first_of(t[2])] = first_of(t[0]);
  }
  std::vector<int> counts(parent.size(), 0);
  for (const auto& t : mesh.triangles) ++counts[first_of(t[0])];
  const auto largest = std::max_element(counts.begin(), counts.end()) - counts.begin();
  Mesh piece;
  std::vector<int> place(parent.size(), -1);
  for (std::array<int, 3> t : mesh.triangles) {
    if (first_of(t[0]) != largest) continue;
    for (int& v : t) {
      if (place[v] < 0) place[v] = piece.AddVertex(mesh.positions[v], mesh.normals[v], mesh.uvs[v]);
      v = place[v];
    }
    piece.triangles.push_back(t);
  }
  return piece;
}

}  // namespace drydock::scenes
