#include "scenes/mesh/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/mesh/lattice_noise.h"
#include "sensors_models/base/check.h"

namespace drydock::scenes {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Any unit vector across `direction`.
Vector3d Across(const Vector3d& direction) {
  const Vector3d helper = std::abs(direction.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
  return direction.cross(helper).normalized();
}

Vector3d TangentAt(const std::vector<Vector3d>& path, std::size_t i) {
  const std::size_t before = i == 0 ? 0 : i - 1;
  const std::size_t after = std::min(i + 1, path.size() - 1);
  return (path[after] - path[before]).normalized();
}

/// A fan over the ring of vertices `first` ... `first + segments`, seen from `normal`'s side.
void AddCap(Mesh& mesh, int first, int segments, const Vector3d& center, const Vector3d& normal,
            const TileUv& uv, bool reverse) {
  const Vector3d a = Across(normal);
  const Vector3d b = normal.cross(a);
  const auto add = [&](const Vector3d& p) {
    const Vector3d d = p - center;
    return mesh.AddVertex(p, normal, uv.offset + Vector2d(d.dot(a), d.dot(b)) / uv.period);
  };
  const int middle = add(center);
  int previous = add(mesh.positions[first]);
  for (int i = 1; i <= segments; ++i) {
    const int next = add(mesh.positions[first + i]);
    if (reverse) {
      mesh.AddTriangle(middle, next, previous);
    } else {
      mesh.AddTriangle(middle, previous, next);
    }
    previous = next;
  }
}

/// The outline of a box's section with cut corners, counter-clockwise, in the plane of two axes.
std::vector<Vector2d> SectionOutline(double half_a, double half_b, double bevel) {
  const double c = std::min({bevel, half_a, half_b});
  if (c <= 0.0) return {{half_a, -half_b}, {half_a, half_b}, {-half_a, half_b}, {-half_a, -half_b}};
  return {{half_a, -half_b + c},  {half_a, half_b - c},  {half_a - c, half_b},
          {-half_a + c, half_b},  {-half_a, half_b - c}, {-half_a, -half_b + c},
          {-half_a + c, -half_b}, {half_a - c, -half_b}};
}

}  // namespace

Mesh GridSheet(int columns, int rows, const std::function<SurfacePoint(double, double)>& at) {
  Check(columns > 0 && rows > 0, "a sheet needs cells, not {} x {}", columns, rows);
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const SurfacePoint p = at(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      mesh.AddVertex(p.position, Vector3d::Zero(), p.uv);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      const int d = a + columns + 1;
      mesh.AddTriangle(a, a + 1, d + 1);
      mesh.AddTriangle(a, d + 1, d);
    }
  }
  mesh.ComputeSmoothNormals();
  return mesh;
}

Mesh Box(const Vector3d& center, const Vector3d& size, const TileUv& uv, double bevel, int axis) {
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const std::vector<Vector2d> outline = SectionOutline(size[a] / 2, size[b] / 2, bevel);
  const auto point = [&](const Vector2d& section, double along) {
    Vector3d p = center;
    p[axis] += along;
    p[a] += section.x();
    p[b] += section.y();
    return p;
  };
  const auto tile = [&](double s, double t) -> Vector2d {
    return uv.offset + Vector2d(s, t) / uv.period;
  };
  const double half = size[axis] / 2;
  Mesh mesh;
  double s = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& p = outline[i];
    const Vector2d& q = outline[(i + 1) % outline.size()];
    const double next = s + (q - p).norm();
    mesh.AddQuad({point(p, -half), point(q, -half), point(q, half), point(p, half)},
                 {tile(0, s), tile(0, next), tile(2 * half, next), tile(2 * half, s)});
    s = next;
  }
  for (const double side : {-1.0, 1.0}) {
    Vector3d normal = Vector3d::Zero();
    normal[axis] = side;
    std::vector<int> ring;
    ring.reserve(outline.size());
    for (const Vector2d& p : outline) {
      ring.push_back(mesh.AddVertex(point(p, side * half), normal, tile(p.x(), p.y())));
    }
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      if (side > 0) mesh.AddTriangle(ring[0], ring[i], ring[i + 1]);
      if (side < 0) mesh.AddTriangle(ring[0], ring[i + 1], ring[i]);
    }
  }
  return mesh;
}

Mesh Tube(const std::vector<Vector3d>& path, const std::vector<double>& radii, int segments,
          const TileUv& uv, bool caps) {
  Check(path.size() >= 2 && radii.size() == path.size(), "a tube needs a path with radii");
  Mesh mesh;
  const double round = kTurn * radii[0] / uv.period;
  const auto around = [round](double s) {
    if (round >= 0.75) return std::max(1.0, std::round(round)) * s;
    return round * (0.5 - std::abs(s - 0.5));
  };
  Vector3d a = Across(TangentAt(path, 0));
  double along = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3d tangent = TangentAt(path, i);
    a = (a - a.dot(tangent) * tangent).normalized();
    const Vector3d b = tangent.cross(a);
    if (i > 0) along += (path[i] - path[i - 1]).norm();
    for (int k = 0; k <= segments; ++k) {
      const double angle = kTurn * (k % segments) / segments;
      const Vector3d n = std::cos(angle) * a + std::sin(angle) * b;
      mesh.AddVertex(
          path[i] + radii[i] * n, n,
          uv.offset + Vector2d(around(static_cast<double>(k) / segments), along / uv.period));
    }
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    for (int k = 0; k < segments; ++k) {
      const int v = static_cast<int>(i) * (segments + 1) + k;
      const int w = v + segments + 1;
      mesh.AddTriangle(v, v + 1, w + 1);
      mesh.AddTriangle(v, w + 1, w);
    }
  }
  if (caps) {
    const int last = static_cast<int>(path.size() - 1) * (segments + 1);
    AddCap(mesh, 0, segments, path.front(), -TangentAt(path, 0), uv, true);
    AddCap(mesh, last, segments, path.back(), TangentAt(path, path.size() - 1), uv, false);
  }
  return mesh;
}

Mesh Tube(const std::vector<Vector3d>& path, double radius, int segments, const TileUv& uv) {
  return Tube(path, std::vector<double>(path.size(), radius), segments, uv);
}

Mesh Lathe(const std::vector<Vector2d>& profile, int segments, double u_turns, double v_low,
           double v_high) {
  std::vector<double> length(profile.size(), 0.0);
  for (std::size_t i = 1; i < profile.size(); ++i) {
    length[i] = length[i - 1] + (profile[i] - profile[i - 1]).norm();
  }
  const int rows = static_cast<int>(profile.size()) - 1;
  Mesh mesh = GridSheet(segments, rows, [&](double s, double t) -> SurfacePoint {
    const auto row = static_cast<std::size_t>(std::lround(t * rows));
    const int column = static_cast<int>(std::lround(s * segments)) % segments;
    const double angle = kTurn * column / segments;
    const double v = v_low + (v_high - v_low) * length[row] / length.back();
    const double r = profile[row].x();
    return {{r * std::cos(angle), r * std::sin(angle), profile[row].y()}, {u_turns * s, v}};
  });
  // At points on the axis a cell is one triangle.
  std::erase_if(mesh.triangles, [&](const std::array<int, 3>& t) {
    const Vector3d ab = mesh.positions[t[1]] - mesh.positions[t[0]];
    const Vector3d ac = mesh.positions[t[2]] - mesh.positions[t[0]];
    return ab.cross(ac).squaredNorm() < 1e-18;
  });
  // The seam's two columns are one: give both the same normals.
  for (int j = 0; j <= rows; ++j) {
    Vector3d& first = mesh.normals[static_cast<std::size_t>(j) * (segments + 1)];
    Vector3d& last = mesh.normals[static_cast<std::size_t>(j) * (segments + 1) + segments];
    const Vector3d sum = first + last;
    if (sum.squaredNorm() > 0) first = last = sum.normalized();
  }
  return mesh;
}

std::vector<double> ArcFractions(const std::vector<Vector3d>& line) {
  std::vector<double> fractions(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    fractions[i] = fractions[i - 1] + (line[i] - line[i - 1]).norm();
  }
  for (double& f : fractions) f /= fractions.back();
  return fractions;
}

Mesh Disc(double radius, int segments, const UvRect& uv) {
  Mesh mesh;
  mesh.AddVertex(Vector3d::Zero(), Vector3d::UnitZ(), uv.At(0.5, 0.5));
  for (int i = 0; i < segments; ++i) {
    const double c = std::cos(kTurn * i / segments);
    const double s = std::sin(kTurn * i / segments);
    mesh.AddVertex({radius * c, radius * s, 0}, Vector3d::UnitZ(),
                   uv.At(0.5 + 0.5 * c, 0.5 - 0.5 * s));
  }
  for (int i = 0; i < segments; ++i) mesh.AddTriangle(0, 1 + i, 1 + (i + 1) % segments);
  return mesh;
}

Mesh Rock(const Vector3d& size, int cells, double roughness, std::uint64_t key, const TileUv& uv) {
  const auto surface = [&](const Vector3d& direction) -> Vector3d {
    const double dent =
        Fbm3(1.6 * direction, 4, key) + 0.35 * std::abs(Fbm3(3.1 * direction, 2, key + 1));
    return (1.0 + roughness * dent) * direction.cwiseProduct(size / 2);
  };
  Mesh mesh;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    mesh.Append(GridSheet(cells, cells, [&](double s, double t) -> SurfacePoint {
      // Equal angles, so that the faces' cells are about equally large on the ball.
      const double a = std::tan((s - 0.5) * kTurn / 4);
      const double b = std::tan((t - 0.5) * kTurn / 4);
      Vector3d cube;
      cube[axis] = sign;
      cube[(axis + 1) % 3] = sign * a;
      cube[(axis + 2) % 3] = b;
      const Vector3d p = surface(cube.normalized());
      const Vector2d place(size[(axis + 1) % 3] * 0.5 * a, size[(axis + 2) % 3] * 0.5 * b);
      const Vector2d shift(0.37 * face, 0.61 * face);
      return {p, uv.offset + shift + place / uv.period};
    }));
  }
  return mesh;
}

Mesh GroundTile(const Vector2d& corner, double size, int cells,
                const std::function<double(const Vector2d&)>& height,
                const std::function<Vector2d(const Vector2d&)>& uv) {
  return GridSheet(cells, cells, [&](double s, double t) -> SurfacePoint {
    const Vector2d p = corner + size * Vector2d(s, t);
    return {{p.x(), p.y(), height(p)}, uv(p)};
  });
}

void Wear(Mesh& mesh, double size, double depth, std::uint64_t key) {
  for (Vector3d& p : mesh.positions) {
    const Vector3d q = p / size;
    p += depth * Vector3d(Fbm3(q, 2, key), Fbm3(q, 2, key + 1), Fbm3(q, 2, key + 2));
  }
  mesh.ComputeSmoothNormals();
}

Mesh Ribbon(const std::vector<Vector3d>& spine, const std::vector<double>& half_widths,
            const Vector3d& side, const UvRect& uv) {
  const int rows = static_cast<int>(spine.size()) - 1;
  Mesh mesh = GridSheet(1, rows, [&](double s, double t) -> SurfacePoint {
    const auto i = static_cast<std::size_t>(std::lround(t * rows));
    return {spine[i] + (2 * s - 1) * half_widths[i] * side, uv.At(s, 1 - t)};
  });
  mesh.AddBackFaces();
  return mesh;
}

}  // namespace drydock::scenes
