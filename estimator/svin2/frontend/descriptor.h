// Binary descriptors and how alike they are.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace drydock::svin2 {

/// 512 bits of BRISK (Leutenegger, Chli and Siegwart 2011).
using Descriptor = std::array<std::uint64_t, 8>;

/// The number of bits that differ, 0 to 512.
inline int HammingDistance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) distance += std::popcount(a[i] ^ b[i]);
  return distance;
}

}  // namespace drydock::svin2
