// Draws both eyes' views on a thread of its own, while others work on the pair before.
#pragma once

#include <array>
#include <future>
#include <memory>
#include <string>

#include "sensors_models/base/worker.h"
#include "sim/render/renderer.h"

namespace drydock::sim {

using RawPair = std::array<RawImage, 2>;

/// A Renderer for two eyes. The world must outlive it.
class StereoRenderer {
 public:
  /// Draws nothing beyond `far_m`, see Renderer::SetFar. InputError if the backend does not work.
  StereoRenderer(World& world, RendererBackend backend, const std::array<Pinhole, 2>& pinholes,
                 double far_m);
  /// Waits for what was begun.
  ~StereoRenderer();
  StereoRenderer(const StereoRenderer&) = delete;
  StereoRenderer& operator=(const StereoRenderer&) = delete;

  /// Begins to draw a pair, with the world's moving bodies at `moving` (see Renderer::Place); the
  /// one begun before must be finished.
  void Begin(const std::array<Pose, 2>& T_WC, const MovingPoses& moving = {});
  bool HasBegun() const { return drawing_.valid(); }
  /// Waits for the pair that was begun. It is valid until the next call.
  const RawPair& Finish();

  /// "egl" or "osmesa".
  const std::string& BackendName() const { return backend_name_; }
  /// OpenGL's name for the device, for reports.
  const std::string& DeviceName() const { return device_name_; }

 private:
  std::array<Pinhole, 2> pinholes_;
  std::string backend_name_;
  std::string device_name_;
  std::unique_ptr<Renderer> renderer_;  ///< Lives and dies on the worker's thread.
  std::array<RawPair, 2> pairs_;        ///< One in work, one handed out.
  std::size_t in_work_ = 0;
  Worker worker_;
  std::future<void> drawing_;
};

}  // namespace drydock::sim
