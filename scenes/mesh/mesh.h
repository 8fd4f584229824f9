// Triangle meshes with normals and texture coordinates: what every scene's parts are made of.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace drydock::scenes {

/// Triangles are counter-clockwise seen from outside; the renderer culls the other side. Texture
/// coordinates have (0, 0) at the image's first pixel, u to the right and v down the rows.
struct Mesh {
  std::vector<Eigen::Vector3d> positions;     ///< [m]
  std::vector<Eigen::Vector3d> normals;       ///< unit vectors, one a vertex
  std::vector<Eigen::Vector2d> uvs;           ///< one a vertex
  std::vector<std::array<int, 3>> triangles;  ///< vertex indices

  bool IsEmpty() const { return triangles.empty(); }
  /// The new vertex's index.
  int AddVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal,
                const Eigen::Vector2d& uv);
  void AddTriangle(int a, int b, int c) { triangles.push_back({a, b, c}); }
  /// Four corners counter-clockwise, with vertices of their own and the normal of their plane.
  void AddQuad(const std::array<Eigen::Vector3d, 4>& corners,
               const std::array<Eigen::Vector2d, 4>& corner_uvs);
  void Append(const Mesh& other);
  void Transform(const Eigen::Isometry3d& transform);
  /// Appends the same surface seen from behind, for thin things such as leaves.
  void AddBackFaces();
  /// Normals from the triangles around each vertex, weighted by their area.
  void ComputeSmoothNormals();
  /// Drops the triangles of which all corners are `unwanted`, and the vertices that none needs.
  void Erase(const std::function<bool(const Eigen::Vector3d& position)>& unwanted);
  /// Mirrors y and keeps the outside out.
  void MirrorY();
};

/// The surface seen from behind.
Mesh Flipped(const Mesh& mesh);

/// [m^2].
double SurfaceArea(const Mesh& mesh);
/// Signed volume by the divergence theorem, positive if a closed mesh's outside is out [m^3].
double EnclosedVolume(const Mesh& mesh);
/// Edges (between positions, however many vertices share one) without a partner of the opposite
/// direction; zero for a closed surface.
std::size_t CountOpenEdges(const Mesh& mesh);

}  // namespace drydock::scenes
