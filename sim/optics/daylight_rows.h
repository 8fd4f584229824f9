// The inner loops of DaylightGrid: plain arrays that do not overlap, the same bits on every
// instruction set (see optics_rows.h).
#pragma once

#include <cstdint>

namespace drydock::sim::rows {

struct Lattice {
  float origin[3];   ///< [m], in W.
  float per_metre;   ///< Points a metre.
  int bricks[3];     ///< Along each axis.
  float highest[3];  ///< Largest coordinate, in points.
};

/// Number of the brick of each place.
void Bricks(const Lattice& lattice, int count, const float* x, const float* y, const float* z,
            int* brick);
/// Light at each place by interpolation between the eight points around it; `first` is where the
/// points of each brick begin.
void Interpolate(const Lattice& lattice, const int* first, const std::uint32_t* points, int count,
                 const float* x, const float* y, const float* z, const int* brick, float* sun,
                 float* sky);

/// half[i] = all[2 i], `count` elements.
void TakeEveryOther(int count, const float* all, float* half);
/// Light at each of `count` pixels from that at every other one, the first one included; between
/// two it is that of the one that is nearer in depth, so that it does not run over silhouettes.
void SpreadToPixels(int count, const float* depth, const float* half, float* light);

}  // namespace drydock::sim::rows
