// What gl_context.cc needs of the two backends; not for others.
#pragma once

#include "sim/render/gl_context.h"

namespace drydock::sim::internal {

using GlFunction = void (*)();
using GetProcAddress = GlFunction (*)(const char* name);

/// Hands MuJoCo's OpenGL look-ups to `lookup` from now on.
void UseForLookup(GetProcAddress lookup);

/// nullptr and a reason in `why_not` if the backend does not work here.
std::unique_ptr<GlContext> CreateEglContext(std::string& why_not);
std::unique_ptr<GlContext> CreateOsmesaContext(std::string& why_not);

/// dlopen with local symbols; nullptr if the library is not there.
void* OpenLibrary(const char* name);
void* FindSymbol(void* library, const char* name);

template <typename Function>
Function* Find(void* library, const char* name) {
  return reinterpret_cast<Function*>(FindSymbol(library, name));
}

}  // namespace drydock::sim::internal
