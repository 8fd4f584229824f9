#include "sim/world/world.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "sensors_models/base/check.h"
#include "sim/world/mujoco_errors.h"

namespace drydock::sim {
namespace {

using Message = std::array<char, 1024>;

mjModel* LoadScene(const std::filesystem::path& mjcf) {
  Message error = {};
  mjModel* model = mj_loadXML(mjcf.c_str(), nullptr, error.data(), error.size());
  RequireInput(model != nullptr, "{}: {}", mjcf.string(), error.data());
  return model;
}

/// Adds a material that shows the picture `file`.
void AddMaterial(mjSpec* spec, const std::string& name, const std::filesystem::path& file) {
  mjsTexture* texture = mjs_addTexture(spec, nullptr);
  mjs_setName(texture->element, name.c_str());
  texture->type = mjTEXTURE_2D;
  mjs_setString(texture->file, std::filesystem::absolute(file).c_str());
  mjsMaterial* material = mjs_addMaterial(spec, nullptr);
  mjs_setName(material->element, name.c_str());
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, name.c_str());
}

void AddBody(mjSpec* spec, const MovingBody& moving, const std::string& material) {
  mjsMesh* mesh = mjs_addMesh(spec, nullptr);
  mjs_setName(mesh->element, moving.name.c_str());
  mjs_setString(mesh->file, std::filesystem::absolute(moving.mesh).c_str());
  std::fill_n(mesh->scale, 3, moving.scale);
  mesh->inertia = mjMESH_INERTIA_SHELL;  // Fins have no volume.
  mjsBody* body = mjs_addBody(mjs_findBody(spec, "world"), nullptr);
  mjs_setName(body->element, moving.name.c_str());
  body->mocap = 1;
  mjsGeom* geom = mjs_addGeom(body, nullptr);
  geom->type = mjGEOM_MESH;
  mjs_setString(geom->meshname, moving.name.c_str());
  mjs_setString(geom->material, material.c_str());
  std::fill_n(geom->rgba, 3, moving.tint);
  geom->rgba[3] = 1.0F;
  geom->contype = 0;
  geom->conaffinity = 0;
}

mjModel* LoadSceneWith(const std::filesystem::path& mjcf, const std::vector<MovingBody>& bodies) {
  Message error = {};
  const std::unique_ptr<mjSpec, void (*)(mjSpec*)> spec(
      mj_parseXML(mjcf.c_str(), nullptr, error.data(), error.size()), mj_deleteSpec);
  RequireInput(spec != nullptr, "{}: {}", mjcf.string(), error.data());
  std::map<std::filesystem::path, std::string> materials;
  for (const MovingBody& body : bodies) {
    const auto [material, added] =
        materials.try_emplace(body.texture, fmt::format("moving/{}", materials.size()));
    if (added) AddMaterial(spec.get(), material->second, body.texture);
    AddBody(spec.get(), body, material->second);
  }
  mjModel* model = mj_compile(spec.get(), nullptr);
  RequireInput(model != nullptr, "{}, with what moves: {}", mjcf.string(),
               mjs_getError(spec.get()));
  return model;
}

}  // namespace

World::World(const std::filesystem::path& mjcf, MovingThings moving) : moving_(std::move(moving)) {
  InstallMujocoErrorHandlers();
  const std::vector<MovingBody>& bodies = moving_.bodies();
  model_.reset(bodies.empty() ? LoadScene(mjcf) : LoadSceneWith(mjcf, bodies));
  for (const MovingBody& body : bodies)
    moving_geoms_.push_back(
        model_->body_geomadr[mj_name2id(model_.get(), mjOBJ_BODY, body.name.c_str())]);
  data_.reset(mj_makeData(model_.get()));
  mj_forward(model_.get(), data_.get());
}

std::string World::BodyOfGeom(int geom) const {
  const char* name = mj_id2name(model_.get(), mjOBJ_BODY, model_->geom_bodyid[geom]);
  return name == nullptr ? std::string("unnamed") : std::string(name);
}

}  // namespace drydock::sim
