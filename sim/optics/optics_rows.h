// The inner loops of the optics: one image row a call, plain arrays, written so that compilers
// vectorise them. They use no contraction and no reassociation, so that every instruction set gives
// the same bits.
#pragma once

namespace drydock::sim::rows {

/// Geometry of one row and of the camera.
struct RowView {
  const float* columns;  ///< (u - cx) / focal of each pixel.
  float y;               ///< (v - cy) / focal.
  int width;
  float inverse_focal;
  float up_C[3];   ///< W's z axis, in C.
  float sun_C[3];  ///< Direction to the sun, in C.
};

/// Range along each ray [m] and the ray's upward slope (sine of its elevation) from the depth along
/// the axis.
void RangesAndSlopes(const RowView& view, const float* depth, float* range, float* slope);

/// Light that falls on each pixel's surface, as a share of what a flat surface gets. The normal is
/// that of the depth image, on each axis towards the neighbour that is nearer in depth, so that it
/// does not mix two surfaces at a silhouette. `above` and `below` are the neighbouring rows of
/// `depth`.
void Illumination(const RowView& view, const float* above, const float* depth, const float* below,
                  float sun_share, float* light);

/// Radiance of one channel, see UnderwaterOptics.
void SeeThroughWater(int width, const float* albedo, const float* light, const float* range,
                     const float* slope, float beam_attenuation, float diffuse_attenuation,
                     float veil, float* radiance);

}  // namespace drydock::sim::rows
