// Skins over closed rings, and thin fins: what animals and limbs are made of.
#pragma once

#include <functional>
#include <vector>

#include "scenes/mesh/mesh.h"
#include "scenes/mesh/shapes.h"

namespace drydock::scenes::creatures {

/// A curve through points of increasing x, smooth where neighbours allow it, as a function of x;
/// beyond the first and the last point their y. Kruger's constrained cubic: it never overshoots.
class Profile {
 public:
  explicit Profile(std::vector<Eigen::Vector2d> points);
  double At(double x) const;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> slopes_;
};

/// A closed surface over `rings` rings of `segments` points each, with a flat lid at either end.
/// `at(ring, angle)` gives the points, angle from 0 to 2 pi round the way along the rings by the
/// right hand. It must give the same at 0 and at 2 pi: the picture has no seam.
Mesh Loft(int rings, int segments, const std::function<SurfacePoint(int ring, double angle)>& at);

/// A thin sheet that is seen from both sides, columns x rows cells, of `at(s, t)` as GridSheet.
Mesh Fin(int columns, int rows, const std::function<SurfacePoint(double s, double t)>& at);

}  // namespace drydock::scenes::creatures
