// The inner loops of the optics: one image row a call, plain arrays that do not overlap, written so
// that compilers vectorise them. They use no contraction and no reassociation, so that every
// instruction set gives the same bits.
#pragma once

namespace drydock::sim::rows {

/// Geometry of one row and of the camera.
struct RowView {
  const float* columns;  ///< (u - cx) / focal of each pixel.
  float y;               ///< (v - cy) / focal.
  int width;
  float inverse_focal;
  float up_C[3];     ///< W's z axis, in C.
  float sun_C[3];    ///< Direction to the sun, in C.
  float R_WC[3][3];  ///< Rows of the rotation,
  float p_WC[3];     ///< and the camera's place [m].
};

/// Range along each ray [m] and the ray's upward slope (sine of its elevation) from the depth along
/// the axis.
void RangesAndSlopes(const RowView& view, const float* depth, float* range, float* slope);

/// What the light needs to know of the surface that each pixel sees.
struct SurfaceRow {
  float* sunward;   ///< Cosine between normal and sun, not below 0.
  float* upward;    ///< z of the normal, in W.
  float* place[3];  ///< A little in front of the surface [m], in W.
};

/// The normal is that of the depth image, on each axis towards the neighbour that is nearer in
/// depth, so that it does not mix two surfaces at a silhouette. `above` and `below` are the
/// neighbouring rows of `depth`; places are `offset` [m] off the surface.
void Surfaces(const RowView& view, const float* above, const float* depth, const float* below,
              float offset, const SurfaceRow& surface);

/// Light that falls on each surface, as a share of what a flat one gets in the open. `sun` and
/// `sky` are what shadows leave of the two; `light` is 0 where there is no surface.
void Illuminate(int width, const float* sunward, const float* upward, const float* sun,
                const float* sky, float sun_share, float* light);

/// Water and light of one channel.
struct ChannelWater {
  float beam_attenuation;
  float diffuse_attenuation;
  float veil;      ///< Of deep water seen level.
  float daylight;  ///< At the camera.
  float weight;    ///< Of this channel in the sum.
};

/// Adds one channel's light, see UnderwaterOptics: `direct` that comes from surfaces and `veil`
/// that water scatters; `lit` is the share of that water which is not in shadow.
void AddSeenThroughWater(int width, const ChannelWater& water, const float* albedo,
                         const float* light, const float* range, const float* slope,
                         const float* lit, float* direct, float* veil);

/// radiance += exp(-tau) direct + (1 - exp(-tau)) blurred, with tau = scattering * range and
/// `blurred` between `less` and `more` by variance, see ForwardScatter.
struct BlurMix {
  float scattering;         ///< tau a metre.
  float variance;           ///< Of one bend [px^2].
  float less_variance;      ///< Of the two layers.
  float inverse_variances;  ///< 1 / (variance of more - variance of less)
};
void AddBlurred(int width, const BlurMix& mix, const float* range, const float* direct,
                const float* less, const float* more, float* radiance);

/// How many slices of the veil lie in front of each pixel, above 0: the veil that is seen up to a
/// range grows as 1 - exp(-attenuation * range) from 0 to 1 and is cut into `slices` equal parts.
void SlicesSeen(int width, int slices, float attenuation, const float* range, float* seen);
/// Adds what is lit of slice number `slice` as far as it lies in front of each pixel.
/// `here` is how much of the slice is lit, `before` that of the slice in front of it.
void AddSlice(int width, int slice, const float* seen, const float* before, const float* here,
              float* lit);

void DivideBy(int width, const float* divisor, float* values);

/// out = (1 - share) a + share b.
void Interpolate(int width, const float* a, const float* b, float share, float* out);

/// Stretches `count` values to `spacing` (2, 4, 8, 16 or 32) times as many by straight lines;
/// `coarse` has one more.
void Stretch(int count, int spacing, const float* coarse, float* fine);

}  // namespace drydock::sim::rows
