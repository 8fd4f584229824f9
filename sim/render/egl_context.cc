#include <array>
#include <string_view>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "sim/render/gl_backends.h"

namespace drydock::sim::internal {
namespace {

/// EGL's functions, loaded at run time so that the program starts without EGL too.
struct Egl {
  void* library = nullptr;
  decltype(&::eglGetProcAddress) get_proc_address = nullptr;
  decltype(&::eglInitialize) initialize = nullptr;
  decltype(&::eglBindAPI) bind_api = nullptr;
  decltype(&::eglChooseConfig) choose_config = nullptr;
  decltype(&::eglCreateContext) create_context = nullptr;
  decltype(&::eglDestroyContext) destroy_context = nullptr;
  decltype(&::eglMakeCurrent) make_current = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;

  bool Load(std::string& why_not) {
    library = OpenLibrary("libEGL.so.1");
    if (library == nullptr) {
      why_not = "libEGL.so.1 is not installed";
      return false;
    }
    get_proc_address =
        Find<std::remove_pointer_t<decltype(get_proc_address)>>(library, "eglGetProcAddress");
    initialize = Find<std::remove_pointer_t<decltype(initialize)>>(library, "eglInitialize");
    bind_api = Find<std::remove_pointer_t<decltype(bind_api)>>(library, "eglBindAPI");
    choose_config =
        Find<std::remove_pointer_t<decltype(choose_config)>>(library, "eglChooseConfig");
    create_context =
        Find<std::remove_pointer_t<decltype(create_context)>>(library, "eglCreateContext");
    destroy_context =
        Find<std::remove_pointer_t<decltype(destroy_context)>>(library, "eglDestroyContext");
    make_current = Find<std::remove_pointer_t<decltype(make_current)>>(library, "eglMakeCurrent");
    if (!get_proc_address || !initialize || !bind_api || !choose_config || !create_context ||
        !destroy_context || !make_current) {
      why_not = "libEGL.so.1 lacks functions of EGL 1.4";
      return false;
    }
    get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        get_proc_address("eglGetPlatformDisplayEXT"));
    query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get_proc_address("eglQueryDevicesEXT"));
    query_device_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
        get_proc_address("eglQueryDeviceStringEXT"));
    if (!get_platform_display) {
      why_not = "eglGetPlatformDisplayEXT is missing";
      return false;
    }
    return true;
  }
};

class EglContext final : public GlContext {
 public:
  EglContext(const Egl& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}
  // The display is left initialised: eglTerminate would end every context of the process on it.
  ~EglContext() override {
    Release();
    egl_.destroy_context(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string Name() const override { return "egl"; }
  void MakeCurrent() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  void Release() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

 private:
  Egl egl_;
  EGLDisplay display_;
  EGLContext context_;
};

/// The displays to try, best first: every NVIDIA GPU, then Mesa without a surface.
std::vector<EGLDisplay> CandidateDisplays(const Egl& egl) {
  std::vector<EGLDisplay> displays;
  if (egl.query_devices != nullptr && egl.query_device_string != nullptr) {
    std::array<EGLDeviceEXT, 16> devices = {};
    EGLint count = 0;
    if (!egl.query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) {
      const char* extensions =
          egl.query_device_string(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS);
      if (extensions == nullptr ||
          std::string_view(extensions).find("EGL_NV_device_cuda") == std::string_view::npos) {
        continue;
      }
      displays.push_back(egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT,
                                                  devices[static_cast<std::size_t>(i)], nullptr));
    }
  }
  displays.push_back(
      egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return displays;
}

std::unique_ptr<GlContext> TryDisplay(const Egl& egl, EGLDisplay display, std::string& why_not) {
  if (display == EGL_NO_DISPLAY || !egl.initialize(display, nullptr, nullptr)) {
    why_not = "no display could be initialised";
    return nullptr;
  }
  constexpr std::array<EGLint, 17> kWanted = {EGL_SURFACE_TYPE,
                                              EGL_PBUFFER_BIT,
                                              EGL_RENDERABLE_TYPE,
                                              EGL_OPENGL_BIT,
                                              EGL_RED_SIZE,
                                              8,
                                              EGL_GREEN_SIZE,
                                              8,
                                              EGL_BLUE_SIZE,
                                              8,
                                              EGL_ALPHA_SIZE,
                                              8,
                                              EGL_DEPTH_SIZE,
                                              24,
                                              EGL_STENCIL_SIZE,
                                              8,
                                              EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl.bind_api(EGL_OPENGL_API) ||
      !egl.choose_config(display, kWanted.data(), &config, 1, &count) || count < 1) {
    why_not = "the display offers no OpenGL configuration";
    return nullptr;
  }
  EGLContext context = egl.create_context(display, config, EGL_NO_CONTEXT, nullptr);
  if (context == EGL_NO_CONTEXT ||
      !egl.make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    why_not = "no OpenGL context could be made";
    return nullptr;
  }
  return std::make_unique<EglContext>(egl, display, context);
}

}  // namespace

std::unique_ptr<GlContext> CreateEglContext(std::string& why_not) {
  Egl egl;
  if (!egl.Load(why_not)) return nullptr;
  for (EGLDisplay display : CandidateDisplays(egl)) {
    if (auto context = TryDisplay(egl, display, why_not)) {
      UseForLookup(egl.get_proc_address);
      return context;
    }
  }
  return nullptr;
}

}  // namespace drydock::sim::internal
