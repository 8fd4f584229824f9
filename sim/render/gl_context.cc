#include "sim/render/gl_context.h"

#include <atomic>

#include <dlfcn.h>

#include "sensors_models/base/check.h"
#include "sim/render/gl_backends.h"

namespace drydock::sim {
namespace internal {
namespace {

// MuJoCo finds OpenGL by asking the process's global scope for a function named eglGetProcAddress.
// Were EGL and OSMesa both linked or loaded globally, the first found would win, whatever the user
// chose. So the program itself exports that name (see CMakeLists.txt) and forwards to the backend
// that was chosen. The look-up is one a process by MuJoCo's design; hence the only mutable global
// of this project.
std::atomic<GetProcAddress> chosen_lookup{nullptr};

}  // namespace

void UseForLookup(GetProcAddress lookup) { chosen_lookup = lookup; }

void* OpenLibrary(const char* name) { return ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void* FindSymbol(void* library, const char* name) { return ::dlsym(library, name); }

}  // namespace internal

RendererBackend ParseRendererBackend(std::string_view name) {
  if (name == "auto") return RendererBackend::kAuto;
  if (name == "egl") return RendererBackend::kEgl;
  if (name == "osmesa") return RendererBackend::kOsmesa;
  RequireInput(false, "renderer is {}, must be one of auto, egl, osmesa", name);
  return RendererBackend::kAuto;
}

std::unique_ptr<GlContext> CreateGlContext(RendererBackend backend) {
  std::string egl_failure = "not tried";
  std::string osmesa_failure = "not tried";
  std::unique_ptr<GlContext> context;
  if (backend != RendererBackend::kOsmesa) context = internal::CreateEglContext(egl_failure);
  if (!context && backend != RendererBackend::kEgl) {
    context = internal::CreateOsmesaContext(osmesa_failure);
  }
  RequireInput(context != nullptr,
               "no offscreen OpenGL: EGL: {}; OSMesa: {}. Install libegl1 and libgl1-mesa-dri, or "
               "libosmesa6",
               egl_failure, osmesa_failure);
  return context;
}

void* FindGlFunction(const char* name) {
  const auto lookup = internal::chosen_lookup.load();
  return lookup == nullptr ? nullptr : reinterpret_cast<void*>(lookup(name));
}

std::string GlRendererName() {
  using GetString = const unsigned char*(unsigned);
  constexpr unsigned kRenderer = 0x1F01, kVersion = 0x1F02;
  auto* get_string = reinterpret_cast<GetString*>(FindGlFunction("glGetString"));
  if (get_string == nullptr) return "unknown";
  const auto text = [&](unsigned what) {
    const unsigned char* value = get_string(what);
    return std::string(value == nullptr ? "unknown" : reinterpret_cast<const char*>(value));
  };
  return text(kRenderer) + ", OpenGL " + text(kVersion);
}

}  // namespace drydock::sim

extern "C" __attribute__((visibility("default"), used)) drydock::sim::internal::GlFunction
eglGetProcAddress(const char* name) {
  const auto lookup = drydock::sim::internal::chosen_lookup.load();
  return lookup == nullptr ? nullptr : lookup(name);
}
