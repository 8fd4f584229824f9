#include "sim/optics/optics_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

// One copy of each function for AVX2 and one for every x86-64, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DRYDOCK_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define DRYDOCK_VECTOR_CLONES
#endif

namespace drydock::sim::rows {
namespace {

/// exp(x) for x in about [-87, 80], relative error below 2e-6; below that range a very small
/// number. 2^(x log2 e), the whole part through the exponent bits, the rest by its Taylor
/// polynomial.
inline __attribute__((always_inline)) float FastExp(float x) {
  const float power = std::max(x * 1.44269504F, -126.F);
  // Adding and taking away 1.5 * 2^23 rounds to the nearest whole number.
  constexpr float kRound = 12582912.F;
  const float whole = (power + kRound) - kRound;
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

}  // namespace

DRYDOCK_VECTOR_CLONES
void RangesAndSlopes(const RowView& view, const float* depth, float* range, float* slope) {
  const float y = view.y;
  const float up_x = view.up_C[0];
  const float up_rest = view.up_C[1] * y + view.up_C[2];
  const float* columns = view.columns;
  const int width = view.width;
  for (int u = 0; u < width; ++u) {
    const float x = columns[u];
    const float length = std::sqrt(1.F + x * x + y * y);
    range[u] = depth[u] * length;
    slope[u] = (up_x * x + up_rest) / length;
  }
}

namespace {

/// Light on one pixel's surface; left and right are its neighbours' depths.
inline __attribute__((always_inline)) float IlluminatePixel(const RowView& view, float x,
                                                            float left, float right, float above,
                                                            float below, float z, float sun_share) {
  const float across = NearerDifference(left, z, right);
  const float down = NearerDifference(above, z, below);
  // The surface is P(u, v) = z (x, y, 1); its normal is dP/du x dP/dv, turned towards the camera.
  const float toward = z * view.inverse_focal + x * across + view.y * down;
  const float scale = 1.F / std::sqrt(across * across + down * down + toward * toward);
  const float upward =
      (across * view.up_C[0] + down * view.up_C[1] - toward * view.up_C[2]) * scale;
  const float sunward =
      (across * view.sun_C[0] + down * view.sun_C[1] - toward * view.sun_C[2]) * scale;
  // Diffuse light: all of it from above, a quarter (scattered back by water and ground) from below.
  const float sky = 0.625F + 0.375F * upward;
  const float value = sun_share * std::max(0.F, sunward) + (1.F - sun_share) * sky;
  return value >= 0.F ? value : 0.F;  // Also drops what is not a number.
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Illumination(const RowView& row, const float* above, const float* depth, const float* below,
                  float sun_share, float* light) {
  const RowView view = row;  // So that the compiler knows that `light` does not overlap it.
  const int last = view.width - 1;
  light[0] = IlluminatePixel(view, view.columns[0], depth[0], depth[1], above[0], below[0],
                             depth[0], sun_share);
  for (int u = 1; u < last; ++u) {
    light[u] = IlluminatePixel(view, view.columns[u], depth[u - 1], depth[u + 1], above[u],
                               below[u], depth[u], sun_share);
  }
  light[last] = IlluminatePixel(view, view.columns[last], depth[last - 1], depth[last], above[last],
                                below[last], depth[last], sun_share);
}

DRYDOCK_VECTOR_CLONES
void SeeThroughWater(int width, const float* albedo, const float* light, const float* range,
                     const float* slope, float beam_attenuation, float diffuse_attenuation,
                     float veil, float* radiance) {
  const float lowest = 0.3F * beam_attenuation;
  const float source = veil * beam_attenuation;
  // In perfectly clear water there is no veil, and beta is zero.
  const float guard = beam_attenuation > 0.F ? 0.F : 1.F;
  for (int u = 0; u < width; ++u) {
    const float beta = std::max(beam_attenuation - diffuse_attenuation * slope[u], lowest);
    // Daylight at the surface point against that at the camera, exp(Kd s r), times exp(-c r):
    // exp(-beta r). Beyond 60 m nothing is left.
    const float transmitted = FastExp(-beta * std::min(range[u], 1000.F));
    const float deep = source / (beta + guard);
    radiance[u] = albedo[u] * light[u] * transmitted + deep * (1.F - transmitted);
  }
}

}  // namespace drydock::sim::rows
