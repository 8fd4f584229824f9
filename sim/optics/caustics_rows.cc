#include "sim/optics/caustics_rows.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/optics/row_math.h"
#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {
namespace {

constexpr int kWrap = kTileCells - 1;
static_assert((kTileCells & kWrap) == 0, "cells wrap by their low bits");

/// Keeps whole numbers of cells small enough for integers; what is not a number becomes one.
inline __attribute__((always_inline)) float Limit(float cells) {
  constexpr float kFarthest = 1e6F;
  return std::min(std::max(-kFarthest, cells), kFarthest);
}

/// Of surfaces [m].
constexpr float kFar = 1000.F;

}  // namespace

DRYDOCK_VECTOR_CLONES
void AddWave(const RowWave& wave, float* x, float* y) {
  const RowWave w = wave;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i) {
    const float along = w.by_sine * w.sine[i] + w.by_cosine * w.cosine[i];
    x[i] += w.x * along;
    y[i] += w.y * along;
  }
}

DRYDOCK_VECTOR_CLONES
void MeanOfNeighbours(const float* a, const float* b, int shift, float* mean) {
  const int inside = kTileCells - shift;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < inside; ++i) mean[i] = 0.5F * (a[i] + b[i + shift]);
  for (int i = inside; i < kTileCells; ++i) mean[i] = 0.5F * (a[i] + b[i + shift - kTileCells]);
}

DRYDOCK_VECTOR_CLONES
void Land(float column, float row, float stretch, const float* shift_x, const float* shift_y,
          Landing& landing) {
  std::int32_t* cell = landing.cell;
  float* x = landing.x;
  float* y = landing.y;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i) {
    const float at_x = Limit(column + static_cast<float>(i) + stretch * shift_x[i]);
    const float at_y = Limit(row + stretch * shift_y[i]);
    const float whole_x = Round(at_x - 0.5F);
    const float whole_y = Round(at_y - 0.5F);
    x[i] = at_x - whole_x;
    y[i] = at_y - whole_y;
    cell[i] = (static_cast<std::int32_t>(whole_x) & kWrap) +
              kTileCells * (static_cast<std::int32_t>(whole_y) & kWrap);
  }
}

void ShareOut(const Landing& landing, float* shares) {
  for (int i = 0; i < kTileCells; ++i) {
    const float x = landing.x[i], y = landing.y[i];
    Eigen::Map<Eigen::Array4f> cell(shares + std::ptrdiff_t{4} * landing.cell[i]);
    cell += Eigen::Array4f(1.F - x, x, 1.F - x, x) * Eigen::Array4f(1.F - y, 1.F - y, y, y);
  }
}

DRYDOCK_VECTOR_CLONES
void GatherShares(const float* cells, const float* cells_above, float factor, float* out) {
  constexpr int kLast = 4 * (kTileCells - 1);
  out[0] = factor * ((cells[0] + cells[kLast + 1]) + (cells_above[2] + cells_above[kLast + 3]));
  DRYDOCK_NO_OVERLAP
  for (int i = 1; i < kTileCells; ++i) {
    out[i] = factor * ((cells[4 * i] + cells[4 * i - 3]) +
                       (cells_above[4 * i + 2] + cells_above[4 * i - 1]));
  }
}

DRYDOCK_VECTOR_CLONES
void BlurDown(int reach, const float* weights, const float* const* in, float* out) {
  const float* middle = in[0];
  const float own = weights[0];
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i) out[i] = own * middle[i];
  for (int tap = 1; tap <= reach; ++tap) {
    const float* above = in[-tap];
    const float* below = in[tap];
    const float weight = weights[tap];
    DRYDOCK_NO_OVERLAP
    for (int i = 0; i < kTileCells; ++i) out[i] += weight * (above[i] + below[i]);
  }
}

DRYDOCK_VECTOR_CLONES
void BlurAcross(int reach, const float* weights, float offset, const float* in, float* out) {
  float padded[3 * kTileCells];
  std::copy_n(in, kTileCells, padded);
  std::copy_n(in, kTileCells, padded + kTileCells);
  std::copy_n(in, kTileCells, padded + 2 * kTileCells);
  const float* middle = padded + kTileCells;
  const float own = weights[0];
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i) out[i] = offset + own * middle[i];
  for (int tap = 1; tap <= reach; ++tap) {
    const float* left = middle - tap;
    const float* right = middle + tap;
    const float weight = weights[tap];
    DRYDOCK_NO_OVERLAP
    for (int i = 0; i < kTileCells; ++i) out[i] += weight * (left[i] + right[i]);
  }
}

DRYDOCK_VECTOR_CLONES
void Pack(const float* factors, std::uint32_t* words) {
  std::int32_t steps[kTileCells + 1];
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i) {
    steps[i] = static_cast<std::int32_t>(Round(std::min(factors[i] * kStepsOfFactor, 65535.F)));
  }
  steps[kTileCells] = steps[0];
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < kTileCells; ++i)
    words[i] = static_cast<std::uint32_t>(steps[i]) | static_cast<std::uint32_t>(steps[i + 1])
                                                          << 16;
}

DRYDOCK_VECTOR_CLONES
void TileNumbers(const CausticTiles& tiles, int count, const float* z, float* number) {
  const float surface_z = tiles.surface_z, per_root_metre = tiles.per_root_metre;
  const float last = tiles.last;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i)
    number[i] = std::min(per_root_metre * std::sqrt(std::max(0.F, surface_z - z[i])), last);
}

namespace {

/// Between the two cells of a word, in steps.
inline __attribute__((always_inline)) float Between(std::uint32_t word, float right) {
  const auto left_cell = static_cast<float>(static_cast<std::int32_t>(word & 0xFFFFU));
  const auto right_cell = static_cast<float>(static_cast<std::int32_t>(word >> 16));
  return Mix(left_cell, right_cell, right);
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Modulate(const CausticTiles& given, int count, const float* x, const float* y, const float* z,
              const float* number, float* light) {
  const CausticTiles tiles = given;
  const std::uint32_t* words = tiles.words;
  constexpr int kCells = kTileCells * kTileCells;
  const float highest = tiles.last - 1.F;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i) {
    const float depth = std::max(0.F, tiles.surface_z - z[i]);
    const float column = Limit(tiles.cells_per_metre * (x[i] + tiles.toward_sun[0] * depth));
    const float row = Limit(tiles.cells_per_metre * (y[i] + tiles.toward_sun[1] * depth));
    const float whole_column = Round(column - 0.5F), whole_row = Round(row - 0.5F);
    const float right = column - whole_column;
    const float down = row - whole_row;
    const int above = static_cast<int>(std::min(number[i], highest));
    const float deeper = number[i] - static_cast<float>(above);
    const int corner = kCells * above + (static_cast<int>(whole_column) & kWrap);
    const int row0 = kTileCells * (static_cast<int>(whole_row) & kWrap);
    const int row1 = (row0 + kTileCells) & (kCells - 1);
    const float shallow =
        Mix(Between(words[corner + row0], right), Between(words[corner + row1], right), down);
    const float deep = Mix(Between(words[corner + row0 + kCells], right),
                           Between(words[corner + row1 + kCells], right), down);
    light[i] *= (1.F / kStepsOfFactor) * Mix(shallow, deep, deeper);
  }
}

DRYDOCK_VECTOR_CLONES
void PlacesSeen(const RowView& row, int count, const float* depth, float* x, float* y, float* z) {
  const RowView view = row;
  float by_column[3], fixed[3];
  for (int i = 0; i < 3; ++i) {
    by_column[i] = view.R_WC[i][0];
    fixed[i] = view.R_WC[i][1] * view.y + view.R_WC[i][2];
  }
  const float* columns = view.columns;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < count; ++i) {
    const float column = columns[2 * i];
    const float along = depth[2 * i];
    x[i] = view.p_WC[0] + along * (by_column[0] * column + fixed[0]);
    y[i] = view.p_WC[1] + along * (by_column[1] * column + fixed[1]);
    const float height = view.p_WC[2] + along * (by_column[2] * column + fixed[2]);
    z[i] = along < kFar ? height : kFar;
  }
}

DRYDOCK_VECTOR_CLONES
void MultiplyByEveryOther(int width, const float* depth, const float* half, float* light) {
  // Between two that are infinite the difference is not a number: that becomes kFar, too.
  const int pairs = (width - 1) / 2;
  DRYDOCK_NO_OVERLAP
  for (int i = 0; i < pairs; ++i) {
    const float left = std::min(kFar, std::abs(depth[2 * i + 1] - depth[2 * i])) + 1e-6F;
    const float right = std::min(kFar, std::abs(depth[2 * i + 2] - depth[2 * i + 1])) + 1e-6F;
    light[2 * i] *= half[i];
    light[2 * i + 1] *= Mix(half[i], half[i + 1], left / (left + right));
  }
  for (int u = 2 * pairs; u < width; ++u) light[u] *= half[pairs];
}

}  // namespace drydock::sim::rows
