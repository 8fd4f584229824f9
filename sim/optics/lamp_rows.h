// The inner loops of lamps: one image row a call, plain arrays that do not overlap, the same bits
// on every instruction set (see optics_rows.h).
#pragma once

#include "sim/optics/optics_rows.h"

namespace drydock::sim::rows {

/// Unit normals of a row's surfaces, in C.
struct NormalRow {
  float* x;
  float* y;
  float* z;
};
void Normals(const RowView& view, const float* above, const float* depth, const float* below,
             const NormalRow& normal);

/// A lamp as one camera has it.
struct Lamp {
  float position_C[3];  ///< [m]
  float axis_C[3];
  float sharpness;  ///< k of LampConfig.
  float nearest;    ///< Square of the distance within which its light grows no more [m^2].
};

/// What a lamp of intensity 1 cd throws on each surface if the water is clear: share[u] [lx], and
/// the light's way to it and on to the camera, way[u] [m]. `range` are the surfaces' ranges.
void LampOnSurfaces(const RowView& view, const Lamp& lamp, const float* depth, const float* range,
                    const NormalRow& normal, float* share, float* way);

/// direct += brightness * albedo * lit * share * exp(-attenuation * way).
void AddLampLight(int width, float brightness, float attenuation, const float* albedo,
                  const float* lit, const float* share, const float* way, float* direct);

/// sum += what of `piece` lies in front of each pixel: all of it beyond `end`, none before `begin`,
/// its part in between [m].
void AddPiece(int width, float begin, float end, const float* range, const float* piece,
              float* sum);

/// Light at each pixel from that at the corners of a raster's cell: `above` and `below` are its
/// values left (0) and right (1) of each pixel with the surfaces' depths there; a corner counts by
/// its nearness, and not at all where its depth is another surface's.
struct RasterCorners {
  const float* value[2];
  const float* depth[2];
};
void SpreadFromRaster(int width, int raster, float down, const float* depth,
                      const RasterCorners& above, const RasterCorners& below, float* value);

}  // namespace drydock::sim::rows
