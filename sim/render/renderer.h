// What a perfect pinhole camera sees of the world: colour without light and distance without noise.
#pragma once

#include <memory>
#include <string>

#include <opencv2/core/mat.hpp>

#include "sensors_models/base/pose.h"
#include "sim/render/gl_context.h"
#include "sim/render/pinhole.h"
#include "sim/world/world.h"

namespace drydock::sim {

/// One view. Rows run from the top down.
struct RawImage {
  cv::Mat albedo;  ///< CV_8UC3, RGB, sRGB-coded reflectance; black where nothing is.
  cv::Mat depth;   ///< CV_32FC1, distance along the optical axis [m]; +infinity where nothing is.
};

/// Draws a world with MuJoCo's renderer, unlit: light is the optics' business. Owns the OpenGL
/// context; use it from one thread at a time. The world must outlive it; only what Place() moves
/// moves.
class Renderer {
 public:
  /// `largest_width` x `largest_height` [px] bounds the views. InputError if the backend does not
  /// work.
  Renderer(World& world, RendererBackend backend, int largest_width, int largest_height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws what the camera at `T_WC` (x right, y down, z forward) sees into `image`, reusing its
  /// memory.
  void Render(const Pose& T_WC, const Pinhole& pinhole, RawImage& image);

  /// Where the world's moving bodies are from now on. An empty list, as at first: none is there.
  void Place(const MovingPoses& poses);

  /// From now on draws nothing that is farther than this along the axis [m], in (kNear, kFar].
  /// Where water hides what is far, drawing it is wasted.
  void SetFar(double far_m);

  /// "egl" or "osmesa".
  std::string BackendName() const;
  /// OpenGL's name for the device, for reports.
  std::string DeviceName() const;

  /// What is nearer than this or farther than that [m] along the axis is never drawn.
  static constexpr double kNear = 0.05;
  static constexpr double kFar = 60.0;

 private:
  struct Mujoco;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<Mujoco> mujoco_;
};

}  // namespace drydock::sim
