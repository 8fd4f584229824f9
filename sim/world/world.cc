#include "sim/world/world.h"

#include <array>

#include "sensors_models/base/check.h"
#include "sim/world/mujoco_errors.h"

namespace drydock::sim {

World::World(const std::filesystem::path& mjcf) {
  InstallMujocoErrorHandlers();
  std::array<char, 1024> error = {};
  model_.reset(mj_loadXML(mjcf.c_str(), nullptr, error.data(), error.size()));
  RequireInput(model_ != nullptr, "{}: {}", mjcf.string(), error.data());
  data_.reset(mj_makeData(model_.get()));
  mj_forward(model_.get(), data_.get());
}

std::string World::BodyOfGeom(int geom) const {
  const char* name = mj_id2name(model_.get(), mjOBJ_BODY, model_->geom_bodyid[geom]);
  return name == nullptr ? std::string("unnamed") : std::string(name);
}

}  // namespace drydock::sim
