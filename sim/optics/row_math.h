// What the inner loops of the optics share (see optics_rows.h). Inlined into each copy of a loop.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "sim/optics/optics_rows.h"

namespace drydock::sim::rows {

/// The nearest whole number of what is below 2^22: adding and taking away 1.5 * 2^23 rounds.
inline __attribute__((always_inline)) float Round(float x) {
  constexpr float kRound = 12582912.F;
  return (x + kRound) - kRound;
}

inline __attribute__((always_inline)) float Mix(float a, float b, float share) {
  return a + share * (b - a);
}

/// exp(x) for x in about [-87, 80], relative error below 2e-6; below that range a very small
/// number. 2^(x log2 e), the whole part through the exponent bits, the rest by its Taylor
/// polynomial.
inline __attribute__((always_inline)) float FastExp(float x) {
  const float power = std::max(x * 1.44269504F, -126.F);
  const float whole = Round(power);
  const float f = (power - whole) * 0.69314718F;
  const float polynomial =
      1.F + f * (1.F + f * (0.5F + f * (0.16666667F + f * (0.041666667F + f * 0.0083333333F))));
  const auto bits = static_cast<std::int32_t>(whole) * (1 << 23);
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(polynomial) + bits);
}

/// Differences towards the nearer neighbour. Beyond the far plane depth is infinite; the result is
/// then not a number, which the caller drops.
inline __attribute__((always_inline)) float NearerDifference(float before, float here,
                                                             float after) {
  const float back = here - before;
  const float ahead = after - here;
  return std::abs(back) < std::abs(ahead) ? back : ahead;
}

struct Normal {
  float x, y, z;
};

/// The unit normal in C, towards the camera, of the surface that a pixel at (x, y) of the image
/// plane sees at depth z between its neighbours' depths.
inline __attribute__((always_inline)) Normal NormalOf(const RowView& view, float x, float left,
                                                      float right, float above, float below,
                                                      float z) {
  const float across = NearerDifference(left, z, right);
  const float down = NearerDifference(above, z, below);
  // The surface is P(u, v) = z (x, y, 1); its normal is dP/du x dP/dv, turned towards the camera.
  const float toward = z * view.inverse_focal + x * across + view.y * down;
  const float scale = 1.F / std::sqrt(across * across + down * down + toward * toward);
  return {across * scale, down * scale, -toward * scale};
}

}  // namespace drydock::sim::rows
