#include "scenes/cave/painting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace drydock::scenes::cave {
namespace {
using Eigen::Vector3d;
using Edge = std::pair<int, int>;
using Triangle = std::array<int, 3>;

Edge EdgeOf(int a, int b) { return std::minmax(a, b); }

/// Moves the line onto vertices that it passes close by, which leaves no slivers.
void Snap(const std::vector<Triangle>& triangles, std::vector<double>& values) {
  constexpr double kClose = 0.2;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      double& a = values[t[i]];
      double& b = values[t[(i + 1) % 3]];
      if (a * b >= 0.0) continue;
      const double along = a / (a - b);
      if (along < kClose) a = 0.0;
      if (along > 1.0 - kClose) b = 0.0;
    }
  }
}

/// Vertices in the middle of edges where the values change their sign.
class EdgeCuts {
 public:
  EdgeCuts(Mesh& mesh, std::vector<double>& values) : mesh_(mesh), values_(values) {}

  void Add(const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = EdgeOf(t[i], t[(i + 1) % 3]);
      if (values_[a] * values_[b] >= 0.0) continue;
      const auto [place, is_new] = cuts_.try_emplace({a, b}, 0);
      if (!is_new) continue;
      const double s = values_[a] / (values_[a] - values_[b]);
      const Vector3d p = mesh_.positions[a] + s * (mesh_.positions[b] - mesh_.positions[a]);
      const Vector3d n = mesh_.normals[a] + s * (mesh_.normals[b] - mesh_.normals[a]);
      place->second = mesh_.AddVertex(p, n.normalized(), Eigen::Vector2d::Zero());
      values_.push_back(0.0);
    }
  }

  /// What becomes of a triangle: itself, or two or three pieces.
  std::vector<Triangle> Pieces(const Triangle& t) const {
    std::array<int, 3> on = {};
    for (int i = 0; i < 3; ++i) {
      const auto it = cuts_.find(EdgeOf(t[i], t[(i + 1) % 3]));
      on[i] = it == cuts_.end() ? -1 : it->second;
    }
    for (int i = 0; i < 3; ++i) {
      const int a = t[i];
      const int b = t[(i + 1) % 3];
      const int c = t[(i + 2) % 3];
      const int on_ab = on[i];
      const int on_ca = on[(i + 2) % 3];
      if (on_ab < 0) continue;
      if (on_ca >= 0) return {{a, on_ab, on_ca}, {on_ab, b, c}, {on_ab, c, on_ca}};
      if (on[(i + 1) % 3] < 0) return {{a, on_ab, c}, {on_ab, b, c}};
    }
    return {t};
  }

 private:
  Mesh& mesh_;
  std::vector<double>& values_;
  std::map<Edge, int> cuts_;
};

}  // namespace

Painting::Painting(Mesh mesh, std::size_t layers)
    : mesh_(std::move(mesh)), labels_(layers, std::vector<int>(mesh_.triangles.size(), 0)) {}

void Painting::Repaint(std::size_t layer, int from, int to, const Field& field) {
  std::vector<bool> asked(mesh_.positions.size(), false);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    for (const int v : mesh_.triangles[i])
      if (labels_[layer][i] == from) asked[v] = true;
  }
  std::vector<double> values(mesh_.positions.size(), 0.0);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (asked[v]) values[v] = field(mesh_.positions[v], mesh_.normals[v]);
  Snap(mesh_.triangles, values);
  EdgeCuts cuts(mesh_, values);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    if (labels_[layer][i] == from) cuts.Add(mesh_.triangles[i]);

  const std::vector<Triangle> before = std::exchange(mesh_.triangles, {});
  const std::vector<std::vector<int>> labels_before =
      std::exchange(labels_, std::vector<std::vector<int>>(labels_.size()));
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (const Triangle& piece : cuts.Pieces(before[i])) {
      mesh_.triangles.push_back(piece);
      for (std::size_t k = 0; k < labels_.size(); ++k) labels_[k].push_back(labels_before[k][i]);
      const double sum = values[piece[0]] + values[piece[1]] + values[piece[2]];
      if (labels_[layer].back() == from && sum > 0.0) labels_[layer].back() = to;
    }
  }
}

}  // namespace drydock::scenes::cave
