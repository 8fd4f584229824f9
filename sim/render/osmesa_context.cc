#include <array>
#include <type_traits>

#include <GL/osmesa.h>

#include "sim/render/gl_backends.h"

namespace drydock::sim::internal {
namespace {

class OsmesaContext final : public GlContext {
 public:
  using MakeCurrentFunction = decltype(&::OSMesaMakeCurrent);
  using DestroyFunction = decltype(&::OSMesaDestroyContext);

  OsmesaContext(OSMesaContext context, MakeCurrentFunction make_current, DestroyFunction destroy)
      : context_(context), make_current_(make_current), destroy_(destroy) {}
  ~OsmesaContext() override { destroy_(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string Name() const override { return "osmesa"; }
  void MakeCurrent() override { TryMakeCurrent(); }
  bool TryMakeCurrent() {
    return make_current_(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
  }
  void Release() override { make_current_(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

 private:
  OSMesaContext context_;
  MakeCurrentFunction make_current_;
  DestroyFunction destroy_;
  /// The window that OSMesa insists on; we draw into a framebuffer object.
  std::array<unsigned char, 4> pixel_ = {};
};

}  // namespace

std::unique_ptr<GlContext> CreateOsmesaContext(std::string& why_not) {
  void* library = OpenLibrary("libOSMesa.so.8");
  if (library == nullptr) {
    why_not = "libOSMesa.so.8 is not installed";
    return nullptr;
  }
  auto* create = Find<decltype(::OSMesaCreateContextExt)>(library, "OSMesaCreateContextExt");
  auto* make_current = Find<decltype(::OSMesaMakeCurrent)>(library, "OSMesaMakeCurrent");
  auto* destroy = Find<decltype(::OSMesaDestroyContext)>(library, "OSMesaDestroyContext");
  auto* lookup = Find<decltype(::OSMesaGetProcAddress)>(library, "OSMesaGetProcAddress");
  if (!create || !make_current || !destroy || !lookup) {
    why_not = "libOSMesa.so.8 lacks functions";
    return nullptr;
  }
  OSMesaContext context = create(GL_RGBA, 24, 8, 0, nullptr);
  if (context == nullptr) {
    why_not = "no OpenGL context could be made";
    return nullptr;
  }
  auto owner = std::make_unique<OsmesaContext>(context, make_current, destroy);
  if (!owner->TryMakeCurrent()) {
    why_not = "the OpenGL context could not be made current";
    return nullptr;
  }
  UseForLookup(lookup);
  return owner;
}

}  // namespace drydock::sim::internal
