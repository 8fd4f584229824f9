// Triangles around what a function of space says is solid: naive surface nets (Gibson, "Constrained
// elastic surface nets", MICCAI 1998).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes {

/// Values of a field on a lattice: negative in the solid, positive outside.
class FieldGrid {
 public:
  /// Covers `box`; the last points may lie beyond its upper corner by less than `cell` [m].
  FieldGrid(const Eigen::AlignedBox3d& box, double cell);

  double cell() const { return cell_; }
  /// Of points along each axis.
  const std::array<int, 3>& counts() const { return counts_; }
  Eigen::Vector3d PointAt(int i, int j, int k) const {
    return low_ + cell_ * Eigen::Vector3d(i, j, k);
  }
  std::size_t IndexOf(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * counts_[1] + j) * counts_[0] + i;
  }
  float At(int i, int j, int k) const { return values_[IndexOf(i, j, k)]; }

  /// Asks `field` at all points of layer k; layers may be filled by several threads.
  void FillLayer(int k, const std::function<double(const Eigen::Vector3d&)>& field);
  void Fill(const std::function<double(const Eigen::Vector3d&)>& field);

 private:
  Eigen::Vector3d low_;
  double cell_;
  std::array<int, 3> counts_ = {};
  std::vector<float> values_;
};

/// One vertex in each cell that the surface passes through, at the mean of where it cuts the cell's
/// edges; normals towards positive values, texture coordinates zero. The surface is closed where it
/// stays off the lattice's rim.
Mesh SurfaceNet(const FieldGrid& grid);

/// The part of `mesh` with the most triangles of those that share no vertex with one another:
/// without what floats and without bubbles.
Mesh LargestPiece(const Mesh& mesh);

}  // namespace drydock::scenes
