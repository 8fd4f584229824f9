// The world of a dive: a MuJoCo model and its state.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

namespace drydock::sim {

/// A loaded MJCF scene with its poses computed. MuJoCo's world frame is W.
class World {
 public:
  /// InputError, with MuJoCo's own words, if the file cannot be loaded.
  explicit World(const std::filesystem::path& mjcf);

  const mjModel& model() const { return *model_; }
  /// For the renderer, which sets the model's visual options; nobody else changes a model.
  mjModel& visual_model() { return *model_; }
  const mjData& data() const { return *data_; }
  mjData& data() { return *data_; }

  /// The name of the body that a geom belongs to; "world" for the world's own.
  std::string BodyOfGeom(int geom) const;

 private:
  struct ModelDeleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DataDeleter {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, ModelDeleter> model_;
  std::unique_ptr<mjData, DataDeleter> data_;
};

}  // namespace drydock::sim
