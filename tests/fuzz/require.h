// What a fuzz target asserts, in every kind of build.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace drydock::fuzz {

inline void Require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace drydock::fuzz
