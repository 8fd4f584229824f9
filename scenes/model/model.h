// A scene in memory, and on disk as MJCF with mesh and texture files beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/mesh/mesh.h"

namespace drydock::scenes {

/// One geom: a mesh in world coordinates with one material. Sonar hits tell the body's name; long
/// parts are several geoms of one body, so that those out of view can be left out.
struct Part {
  std::string body;
  std::string geom;      ///< unique; also the mesh file's name
  std::string material;  ///< a texture's name
  Mesh mesh;
};

/// A scene's static parts and the names of the textures they refer to.
class SceneModel {
 public:
  /// Adds a geom to `body`; the second and later ones of a body are called body_1, body_2...
  void Add(const std::string& body, const std::string& material, Mesh mesh);

  const std::vector<Part>& parts() const { return parts_; }
  std::size_t CountTriangles() const;
  /// Moves the parts from the `first`-th on.
  void TransformFrom(std::size_t first, const Eigen::Isometry3d& transform);

 private:
  std::vector<Part> parts_;
};

/// Writes `directory`/meshes/*.msh and `directory`/scene.xml, which refers to
/// textures/<material>.png. A light, a camera and a haze for whoever opens it in a viewer; a
/// renderer may override them.
void WriteMjcf(const SceneModel& model, const std::string& name,
               const std::filesystem::path& directory);

}  // namespace drydock::scenes
