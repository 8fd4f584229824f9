#include "sim/optics/daylight_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/row_math.h"
#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {
namespace {

constexpr int kBrickBits = 3;
constexpr int kCell = (1 << kBrickBits) - 1;
constexpr int kPoints = (1 << kBrickBits) + 1;

/// The order of the arguments makes zero of what is not a number.
inline __attribute__((always_inline)) float ToPoints(const Lattice& lattice, int axis, float x) {
  return std::min(std::max(0.F, (x - lattice.origin[axis]) * lattice.per_metre),
                  lattice.highest[axis]);
}

inline __attribute__((always_inline)) float Byte(std::uint32_t word, int i) {
  return static_cast<float>(static_cast<int>((word >> (8 * i)) & 0xFFU));
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Bricks(const Lattice& given, int count, const float* x, const float* y, const float* z,
            int* brick) {
  const Lattice lattice = given;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i) {
    const int bx = static_cast<int>(ToPoints(lattice, 0, x[i])) >> kBrickBits;
    const int by = static_cast<int>(ToPoints(lattice, 1, y[i])) >> kBrickBits;
    const int bz = static_cast<int>(ToPoints(lattice, 2, z[i])) >> kBrickBits;
    brick[i] = bx + lattice.bricks[0] * (by + lattice.bricks[1] * bz);
  }
}

DRYDOCK_VECTOR_CLONES
void Interpolate(const Lattice& given, const int* first, const std::uint32_t* points, int count,
                 const float* x, const float* y, const float* z, const int* brick, float* sun,
                 float* sky) {
  const Lattice lattice = given;
  constexpr float kByteToShare = 1.F / 255.F;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i) {
    const float px = ToPoints(lattice, 0, x[i]);
    const float py = ToPoints(lattice, 1, y[i]);
    const float pz = ToPoints(lattice, 2, z[i]);
    const int ix = static_cast<int>(px), iy = static_cast<int>(py), iz = static_cast<int>(pz);
    const float fx = px - static_cast<float>(ix);
    const float fy = py - static_cast<float>(iy);
    const float fz = pz - static_cast<float>(iz);
    const int at =
        first[brick[i]] + (ix & kCell) + kPoints * ((iy & kCell) + kPoints * (iz & kCell));
    const std::uint32_t w00 = points[at], w10 = points[at + 1];
    const std::uint32_t w01 = points[at + kPoints], w11 = points[at + kPoints + 1];
    // Upwards first, then across.
    const float sun0 =
        Mix(Mix(Byte(w00, 0), Byte(w00, 2), fz), Mix(Byte(w10, 0), Byte(w10, 2), fz), fx);
    const float sun1 =
        Mix(Mix(Byte(w01, 0), Byte(w01, 2), fz), Mix(Byte(w11, 0), Byte(w11, 2), fz), fx);
    const float sky0 =
        Mix(Mix(Byte(w00, 1), Byte(w00, 3), fz), Mix(Byte(w10, 1), Byte(w10, 3), fz), fx);
    const float sky1 =
        Mix(Mix(Byte(w01, 1), Byte(w01, 3), fz), Mix(Byte(w11, 1), Byte(w11, 3), fz), fx);
    sun[i] = kByteToShare * Mix(sun0, sun1, fy);
    sky[i] = kByteToShare * Mix(sky0, sky1, fy);
  }
}

DRYDOCK_VECTOR_CLONES
void TakeEveryOther(int count, const float* all, float* half) {
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i) half[i] = all[2 * i];
}

DRYDOCK_VECTOR_CLONES
void SpreadToPixels(int count, const float* depth, const float* half, float* light) {
  const int pairs = (count - 1) / 2;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < pairs; ++i) {
    const float here = depth[2 * i + 1];
    const bool left = std::abs(here - depth[2 * i]) <= std::abs(depth[2 * i + 2] - here);
    light[2 * i] = half[i];
    light[2 * i + 1] = left ? half[i] : half[i + 1];
  }
  for (int u = 2 * pairs; u < count; ++u) light[u] = half[pairs];
}

}  // namespace drydock::sim::rows
