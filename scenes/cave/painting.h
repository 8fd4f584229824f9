// Parts of a surface told apart along smooth lines, rather than along the teeth of its triangles.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes::cave {

/// A mesh whose triangles have a label in each of several layers, 0 at first.
class Painting {
 public:
  using Field = std::function<double(const Eigen::Vector3d& p, const Eigen::Vector3d& normal)>;

  Painting(Mesh mesh, std::size_t layers);

  /// In `layer`, what has the label `from` gets the label `to` where `field` is positive. Triangles
  /// are cut where it changes its sign, their neighbours with them, so that no gaps open.
  void Repaint(std::size_t layer, int from, int to, const Field& field);

  const Mesh& mesh() const { return mesh_; }
  int LabelOf(std::size_t layer, std::size_t triangle) const { return labels_[layer][triangle]; }

 private:
  Mesh mesh_;
  std::vector<std::vector<int>> labels_;  ///< of each layer, one a triangle
};

}  // namespace drydock::scenes::cave
