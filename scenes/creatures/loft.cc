#include "scenes/creatures/loft.h"

#include <numbers>
#include <utility>

#include "sensors_models/base/check.h"

namespace drydock::scenes::creatures {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A lid over the ring that begins with vertex `first`, outside towards `normal`.
void AddLid(Mesh& mesh, int first, int segments, bool at_end) {
  Vector3d middle = Vector3d::Zero();
  Vector2d uv = Vector2d::Zero();
  for (int k = 0; k < segments; ++k) {
    middle += mesh.positions[first + k] / segments;
    uv += mesh.uvs[first + k] / segments;
  }
  const int centre = mesh.AddVertex(middle, Vector3d::Zero(), uv);
  for (int k = 0; k < segments; ++k) {
    const int a = first + k;
    const int b = first + (k + 1) % segments;
    mesh.AddTriangle(centre, at_end ? a : b, at_end ? b : a);
  }
}

}  // namespace

Profile::Profile(std::vector<Vector2d> points) : points_(std::move(points)) {
  Check(points_.size() >= 2, "a profile needs points");
  const auto slope = [this](std::size_t i) {
    const Vector2d d = points_[i + 1] - points_[i];
    return d.y() / d.x();
  };
  slopes_.assign(points_.size(), 0.0);
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const double before = slope(i - 1);
    const double after = slope(i);
    if (before * after > 0) slopes_[i] = 2.0 * before * after / (before + after);
  }
  slopes_.front() = slope(0);
  slopes_.back() = slope(points_.size() - 2);
}

double Profile::At(double x) const {
  if (x <= points_.front().x()) return points_.front().y();
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vector2d& a = points_[i];
    const Vector2d& b = points_[i + 1];
    if (x > b.x()) continue;
    const double h = b.x() - a.x();
    const double t = (x - a.x()) / h;
    const double c = 1.0 - t;
    return c * c * ((1.0 + 2.0 * t) * a.y() + t * h * slopes_[i]) +
           t * t * ((3.0 - 2.0 * t) * b.y() - c * h * slopes_[i + 1]);
  }
  return points_.back().y();
}

Mesh Loft(int rings, int segments, const std::function<SurfacePoint(int, double)>& at) {
  Check(rings >= 2 && segments >= 3, "a loft needs rings, not {} of {} points", rings, segments);
  Mesh mesh;
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < segments; ++k) {
      const SurfacePoint p = at(ring, 2.0 * std::numbers::pi * k / segments);
      mesh.AddVertex(p.position, Vector3d::Zero(), p.uv);
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int k = 0; k < segments; ++k) {
      const int a = ring * segments + k;
      const int b = ring * segments + (k + 1) % segments;
      mesh.AddTriangle(a, b, b + segments);
      mesh.AddTriangle(a, b + segments, a + segments);
    }
  }
  AddLid(mesh, 0, segments, false);
  AddLid(mesh, (rings - 1) * segments, segments, true);
  mesh.ComputeSmoothNormals();
  return mesh;
}

Mesh Fin(int columns, int rows, const std::function<SurfacePoint(double, double)>& at) {
  Mesh mesh = GridSheet(columns, rows, at);
  mesh.AddBackFaces();
  return mesh;
}

}  // namespace drydock::scenes::creatures
