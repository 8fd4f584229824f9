// The cells of the texture `details`: lamps, signs, the grille.
#pragma once

#include "scenes/mesh/shapes.h"

namespace drydock::scenes::bus {

/// Four columns, two rows.
inline UvRect DetailsCell(int column, int row, int columns = 1) {
  const double inset = 0.004;
  return {{0.25 * column + inset, 0.5 * row + inset},
          {0.25 * (column + columns) - inset, 0.5 * (row + 1) - inset}};
}
inline UvRect StopSignCell() { return DetailsCell(0, 0); }
inline UvRect RedLampCell() { return DetailsCell(1, 0); }
inline UvRect AmberLampCell() { return DetailsCell(2, 0); }
inline UvRect HeadlightCell() { return DetailsCell(3, 0); }
inline UvRect GrilleCell() { return DetailsCell(0, 1, 2); }
inline UvRect PlateCell() { return DetailsCell(2, 1); }
inline UvRect MirrorCell() { return DetailsCell(3, 1); }

}  // namespace drydock::scenes::bus
