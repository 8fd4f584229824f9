// The world of a dive: a MuJoCo model and its state.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "sim/world/moving_things.h"

namespace drydock::sim {

/// A loaded MJCF scene with its poses computed. MuJoCo's world frame is W. What moves through it is
/// part of the model too, as mocap bodies after everything else, but never of its state: where it
/// is at an instant is asked of moving().
class World {
 public:
  /// InputError, with MuJoCo's own words, if the file cannot be loaded.
  explicit World(const std::filesystem::path& mjcf) : World(mjcf, MovingThings()) {}
  World(const std::filesystem::path& mjcf, MovingThings moving);

  const mjModel& model() const { return *model_; }
  /// For the renderer, which sets the model's visual options; nobody else changes a model.
  mjModel& visual_model() { return *model_; }
  const mjData& data() const { return *data_; }
  mjData& data() { return *data_; }

  /// The name of the body that a geom belongs to; "world" for the world's own.
  std::string BodyOfGeom(int geom) const;

  const MovingThings& moving() const { return moving_; }
  /// The geom of each moving body, in their order.
  const std::vector<int>& moving_geoms() const { return moving_geoms_; }
  bool IsMoving(int geom) const { return model_->body_mocapid[model_->geom_bodyid[geom]] >= 0; }

 private:
  struct ModelDeleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DataDeleter {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  MovingThings moving_;
  std::vector<int> moving_geoms_;
  std::unique_ptr<mjModel, ModelDeleter> model_;
  std::unique_ptr<mjData, DataDeleter> data_;
};

}  // namespace drydock::sim
