// OpenGL without a window.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace drydock::sim {

enum class RendererBackend {
  kAuto,    ///< EGL if it works, else OSMesa.
  kEgl,     ///< On an NVIDIA GPU if there is one, else Mesa's surfaceless platform.
  kOsmesa,  ///< Mesa's software rasteriser in memory: works everywhere.
};

/// "auto", "egl" or "osmesa"; InputError otherwise.
RendererBackend ParseRendererBackend(std::string_view name);

/// An OpenGL context without a window, current in the thread that made it until it is destroyed.
/// One at a time in a process: MuJoCo looks up OpenGL's functions once, for the first context, so
/// that a process also cannot change its backend once it has drawn.
class GlContext {
 public:
  virtual ~GlContext() = default;
  /// "egl" or "osmesa".
  virtual std::string Name() const = 0;
  /// Makes this thread the one that draws; no other thread may be drawing.
  virtual void MakeCurrent() = 0;
  /// Lets another thread draw.
  virtual void Release() = 0;
};

/// InputError, with what was tried and how each failed, if no context can be had.
std::unique_ptr<GlContext> CreateGlContext(RendererBackend backend);

/// OpenGL's function of this name in the current context's library; nullptr if it has none.
void* FindGlFunction(const char* name);

/// The renderer and driver behind the current context, in OpenGL's words.
std::string GlRendererName();

}  // namespace drydock::sim
