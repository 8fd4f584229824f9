// The view of a perfect camera.
#pragma once

namespace drydock::sim {

/// A pinhole without distortion and with square pixels; pixel centres lie on integers.
struct Pinhole {
  int width = 0;       ///< [px]
  int height = 0;      ///< [px]
  double focal = 0.0;  ///< [px]
  double cx = 0.0;     ///< [px]
  double cy = 0.0;     ///< [px]
};

/// How many cells of `raster` pixels it takes to cover `pixels` of them.
inline int CellsIn(int pixels, int raster) { return (pixels + raster - 1) / raster; }

}  // namespace drydock::sim
