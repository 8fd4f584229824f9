#include "scenes/model/model.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "scenes/mesh/msh_file.h"
#include "sensors_models/base/check.h"
#include "sensors_models/base/files.h"

namespace drydock::scenes {
namespace {

constexpr const char* kHead = R"(<mujoco model="{0}">
  <compiler angle="radian" meshdir="meshes" texturedir="textures"/>
  <statistic center="6 -3.2 0" extent="8"/>
  <visual>
    <global offwidth="1600" offheight="1200" azimuth="120" elevation="-15"/>
    <headlight ambient="0.55 0.6 0.6" diffuse="0.4 0.4 0.35" specular="0 0 0"/>
    <map znear="0.005" zfar="10" fogstart="0.5" fogend="2.5"/>
    <rgba fog="0.12 0.32 0.30 1" haze="0.12 0.32 0.30 1"/>
    <quality shadowsize="0"/>
  </visual>
  <default>
    <mesh inertia="shell"/>
    <material specular="0" shininess="0" reflectance="0"/>
    <geom type="mesh" contype="0" conaffinity="0"/>
  </default>
)";

std::string Assets(const SceneModel& model) {
  std::set<std::string> materials;
  for (const Part& part : model.parts()) materials.insert(part.material);
  std::string xml = "  <asset>\n";
  for (const std::string& name : materials) {
    xml += fmt::format("    <texture name=\"{0}\" type=\"2d\" file=\"{0}.png\"/>\n", name);
    xml += fmt::format("    <material name=\"{0}\" texture=\"{0}\"/>\n", name);
  }
  for (const Part& part : model.parts()) {
    xml += fmt::format("    <mesh name=\"{0}\" file=\"{0}.msh\"/>\n", part.geom);
  }
  return xml + "  </asset>\n";
}

std::string WorldBody(const SceneModel& model) {
  std::vector<std::string> order;
  std::map<std::string, std::string> geoms;
  for (const Part& part : model.parts()) {
    if (!geoms.contains(part.body)) order.push_back(part.body);
    geoms[part.body] += fmt::format("      <geom name=\"{0}\" mesh=\"{0}\" material=\"{1}\"/>\n",
                                    part.geom, part.material);
  }
  std::string xml = "  <worldbody>\n";
  xml +=
      "    <light name=\"daylight\" type=\"directional\" pos=\"0 0 6\" dir=\"0.2 0.1 -1\" "
      "diffuse=\"0.35 0.4 0.38\" specular=\"0 0 0\" castshadow=\"false\"/>\n";
  xml += "    <camera name=\"start\" pos=\"0 0 0\" xyaxes=\"0 -1 0 0 0 1\" fovy=\"55\"/>\n";
  for (const std::string& body : order) {
    xml += fmt::format("    <body name=\"{}\">\n{}    </body>\n", body, geoms.at(body));
  }
  return xml + "  </worldbody>\n</mujoco>\n";
}

}  // namespace

void SceneModel::Add(const std::string& body, const std::string& material, Mesh mesh) {
  if (mesh.IsEmpty()) return;
  const auto same = std::count_if(parts_.begin(), parts_.end(),
                                  [&](const Part& part) { return part.body == body; });
  std::string geom = same == 0 ? body : fmt::format("{}_{}", body, same);
  parts_.push_back({body, std::move(geom), material, std::move(mesh)});
}

std::size_t SceneModel::CountTriangles() const {
  std::size_t count = 0;
  for (const Part& part : parts_) count += part.mesh.triangles.size();
  return count;
}

void SceneModel::TransformFrom(std::size_t first, const Eigen::Isometry3d& transform) {
  for (std::size_t i = first; i < parts_.size(); ++i) parts_[i].mesh.Transform(transform);
}

void WriteMjcf(const SceneModel& model, const std::string& name,
               const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory / "meshes");
  for (const Part& part : model.parts()) {
    WriteMsh(part.mesh, directory / "meshes" / (part.geom + ".msh"));
  }
  const std::string xml = fmt::format(kHead, name) + Assets(model) + WorldBody(model);
  WriteFileAtomically(directory / "scene.xml", xml);
}

}  // namespace drydock::scenes
