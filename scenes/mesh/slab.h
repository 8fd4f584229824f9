// Walls: a panel with rectangular holes, an outside, an inside and the edges between them.
#pragma once

#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes {

/// A wall over a grid of lines in (u, v). The outside is where dp/du x dp/dv points.
struct SlabPlan {
  std::vector<double> u_lines;
  std::vector<double> v_lines;
  /// Whether the cell between lines i, i + 1 and j, j + 1 is open.
  std::function<bool(int i, int j)> is_hole;
  std::function<Eigen::Vector3d(double u, double v)> outer;
  std::function<Eigen::Vector3d(double u, double v)> inner;
  std::function<Eigen::Vector2d(const Eigen::Vector3d& p)> outer_uv;
  std::function<Eigen::Vector2d(const Eigen::Vector3d& p)> inner_uv;
};

struct SlabMeshes {
  /// With the edges, whose texture runs on from the outside into the hole by the wall's thickness.
  Mesh outer;
  Mesh inner;
};

/// The columns first_column ... end_column - 1 of the wall (for culling, long walls are cut into
/// several); there are edges at holes and at the wall's own rim, none at cuts.
SlabMeshes BuildSlab(const SlabPlan& plan, int first_column, int end_column);
SlabMeshes BuildSlab(const SlabPlan& plan);

/// Sorted union of `lines` and steps of at most `step` between them.
std::vector<double> WithSteps(std::vector<double> lines, double step);

}  // namespace drydock::scenes
