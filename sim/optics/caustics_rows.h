// The inner loops of Caustics: plain arrays that do not overlap, the same bits on every instruction
// set (see optics_rows.h).
#pragma once

#include <cstdint>

#include "sim/optics/optics_rows.h"

namespace drydock::sim::rows {

/// A caustic tile has as many cells a side as this; it repeats.
inline constexpr int kTileCells = 256;

/// x[i] += across_x sine[i] + along_x cosine[i], likewise y: one wave's share of a row of shifts.
struct RowWave {
  const float* sine;    ///< Of the wave's angle along the row,
  const float* cosine;  ///< at each of kTileCells places.
  float by_sine;
  float by_cosine;
  float x;  ///< Along which the wave shifts.
  float y;
};
void AddWave(const RowWave& wave, float* x, float* y);

/// mean[i] = (a[i] + b[(i + shift) % kTileCells]) / 2, shift being 0 or 1.
void MeanOfNeighbours(const float* a, const float* b, int shift, float* mean);

/// Where the light of a row of points comes down: the cell, row by row, and the part of the cell's
/// side beyond its middle.
struct Landing {
  std::int32_t cell[kTileCells];
  float x[kTileCells];
  float y[kTileCells];
};
/// A row of points that starts at (`column`, `row`), a cell between each two, and whose light is
/// moved by `stretch` times the shifts [cells].
void Land(float column, float row, float stretch, const float* shift_x, const float* shift_y,
          Landing& landing);

/// Adds to four shares of each cell, for itself, the next, the one below and that one's next, what
/// comes down there, 1 a point.
void ShareOut(const Landing& landing, float* shares);
/// out[i] = factor times the sum of what neighbouring cells gave each other: `cells` and
/// `cells_above` are rows of their shares.
void GatherShares(const float* cells, const float* cells_above, float factor, float* out);

/// out = sum over i of weights[|i|] in[i], along columns: in[0] is the row itself, in[i] that i
/// rows below it, i from -reach to reach.
void BlurDown(int reach, const float* weights, const float* const* in, float* out);
/// Along a row, which repeats; out = offset + sum.
void BlurAcross(int reach, const float* weights, float offset, const float* in, float* out);

/// The words of a row of factors, 16 bits each: the cell's own below, the next one's above.
inline constexpr float kStepsOfFactor = 512.F;  ///< In 1; factors beyond 127.99 become that.
void Pack(const float* factors, std::uint32_t* words);

/// The tiles of all depths and how places find theirs.
struct CausticTiles {
  const std::uint32_t* words;  ///< Of one tile after the other, kTileCells^2 each.
  float surface_z;             ///< [m]
  float per_root_metre;        ///< Tile i is of the depth (i / per_root_metre)^2.
  float last;                  ///< Number of the deepest tile.
  float toward_sun[2];         ///< How far the sun's rays come from the side, a metre of depth.
  float cells_per_metre;
};
/// Depth of each place in tiles, from 0 to `last`.
void TileNumbers(const CausticTiles& tiles, int count, const float* z, float* number);
/// light[i] *= the tiles' factor at each place.
void Modulate(const CausticTiles& tiles, int count, const float* x, const float* y, const float* z,
              const float* number, float* light);

/// Where every other pixel of a row, the first included, sees a surface: `count` places [m, in W].
/// What is farther than 1000 m is high in the air.
void PlacesSeen(const RowView& view, int count, const float* depth, float* x, float* y, float* z);
/// light[u] *= the factor of pixel u, given for every other one. Between two it is theirs, the more
/// of each the nearer it is in depth, so that it does not run over silhouettes.
void MultiplyByEveryOther(int width, const float* depth, const float* half, float* light);

}  // namespace drydock::sim::rows
