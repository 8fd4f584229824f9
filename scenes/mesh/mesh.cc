#include "scenes/mesh/mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace drydock::scenes {
namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;
using Key = std::array<long long, 3>;

/// Positions closer than about a micrometre count as one.
Key RoundedKey(const Vector3d& p) {
  return {std::llround(p.x() * 1e6), std::llround(p.y() * 1e6), std::llround(p.z() * 1e6)};
}

Vector3d AreaVector(const Mesh& mesh, const std::array<int, 3>& t) {
  const Vector3d& a = mesh.positions[t[0]];
  return 0.5 * (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}
}  // namespace

int Mesh::AddVertex(const Vector3d& position, const Vector3d& normal, const Vector2d& uv) {
  positions.push_back(position);
  normals.push_back(normal);
  uvs.push_back(uv);
  return static_cast<int>(positions.size()) - 1;
}

void Mesh::AddQuad(const std::array<Vector3d, 4>& corners,
                   const std::array<Vector2d, 4>& corner_uvs) {
  // The diagonals' cross product also serves where two corners coincide.
  const Vector3d normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
  std::array<int, 4> v{};
  for (int i = 0; i < 4; ++i) v[i] = AddVertex(corners[i], normal, corner_uvs[i]);
  AddTriangle(v[0], v[1], v[2]);
  AddTriangle(v[0], v[2], v[3]);
}

void Mesh::Append(const Mesh& other) {
  const int offset = static_cast<int>(positions.size());
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const auto& t : other.triangles) AddTriangle(t[0] + offset, t[1] + offset, t[2] + offset);
}

void Mesh::Transform(const Eigen::Isometry3d& transform) {
  for (Vector3d& p : positions) p = transform * p;
  for (Vector3d& n : normals) n = transform.linear() * n;
}

void Mesh::AddBackFaces() { Append(Flipped(*this)); }

void Mesh::ComputeSmoothNormals() {
  for (Vector3d& n : normals) n.setZero();
  for (const auto& t : triangles) {
    const Vector3d area = AreaVector(*this, t);
    for (const int i : t) normals[i] += area;
  }
  for (Vector3d& n : normals) n = n.squaredNorm() > 0 ? n.normalized() : Vector3d::UnitZ();
}

void Mesh::Erase(const std::function<bool(const Vector3d&)>& unwanted) {
  std::vector<bool> drop;
  drop.reserve(positions.size());
  for (const Vector3d& p : positions) drop.push_back(unwanted(p));
  Mesh kept;
  std::vector<int> place(positions.size(), -1);
  for (std::array<int, 3> t : triangles) {
    if (drop[t[0]] && drop[t[1]] && drop[t[2]]) continue;
    for (int& i : t) {
      if (place[i] < 0) place[i] = kept.AddVertex(positions[i], normals[i], uvs[i]);
      i = place[i];
    }
    kept.triangles.push_back(t);
  }
  *this = std::move(kept);
}

void Mesh::MirrorY() {
  for (Vector3d& p : positions) p.y() = -p.y();
  for (Vector3d& n : normals) n.y() = -n.y();
  for (auto& t : triangles) std::swap(t[1], t[2]);
}

Mesh Flipped(const Mesh& mesh) {
  Mesh flipped = mesh;
  for (Vector3d& n : flipped.normals) n = -n;
  for (auto& t : flipped.triangles) std::swap(t[1], t[2]);
  return flipped;
}

double SurfaceArea(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) area += AreaVector(mesh, t).norm();
  return area;
}

double EnclosedVolume(const Mesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += AreaVector(mesh, t).dot(mesh.positions[t[0]]) / 3.0;
  }
  return volume;
}

std::size_t CountOpenEdges(const Mesh& mesh) {
  std::map<std::pair<Key, Key>, long long> balance;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Key from = RoundedKey(mesh.positions[t[i]]);
      const Key to = RoundedKey(mesh.positions[t[(i + 1) % 3]]);
      if (from < to) ++balance[{from, to}];
      if (to < from) --balance[{to, from}];
    }
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : balance) open += static_cast<std::size_t>(std::llabs(count));
  return open;
}

}  // namespace drydock::scenes
