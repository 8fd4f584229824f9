#include "sim/optics/optics_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/row_math.h"
#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {
DRYDOCK_VECTOR_CLONES
void RangesAndSlopes(const RowView& view, const float* depth, float* range, float* slope) {
  const float y = view.y;
  const float up_x = view.up_C[0];
  const float up_rest = view.up_C[1] * y + view.up_C[2];
  const float* columns = view.columns;
  const int width = view.width;
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float x = columns[u];
    const float length = std::sqrt(1.F + x * x + y * y);
    range[u] = depth[u] * length;
    slope[u] = (up_x * x + up_rest) / length;
  }
}

namespace {

/// One pixel's surface; left and right are its neighbours' depths.
inline __attribute__((always_inline)) void FindSurface(const RowView& view, float offset, float x,
                                                       float left, float right, float above,
                                                       float below, float z, int u,
                                                       const SurfaceRow& surface) {
  const Normal n = NormalOf(view, x, left, right, above, below, z);
  const float normal[3] = {n.x, n.y, n.z};
  surface.upward[u] =
      normal[0] * view.up_C[0] + normal[1] * view.up_C[1] + normal[2] * view.up_C[2];
  surface.sunward[u] = std::max(
      0.F, normal[0] * view.sun_C[0] + normal[1] * view.sun_C[1] + normal[2] * view.sun_C[2]);
  // Half-way between the normal, which leads away from the surface, and the line of sight, along
  // which there is open water for certain: corners and silhouettes have normals that lead into
  // other walls.
  const float sight = 1.F / std::sqrt(1.F + x * x + view.y * view.y);
  const float half[3] = {normal[0] - x * sight, normal[1] - view.y * sight, normal[2] - sight};
  const float length =
      offset / std::sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
  const float p_C[3] = {x * z + length * half[0], view.y * z + length * half[1],
                        z + length * half[2]};
  for (int i = 0; i < 3; ++i) {
    surface.place[i][u] = view.R_WC[i][0] * p_C[0] + view.R_WC[i][1] * p_C[1] +
                          view.R_WC[i][2] * p_C[2] + view.p_WC[i];
  }
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Surfaces(const RowView& row, const float* above, const float* depth, const float* below,
              float offset, const SurfaceRow& row_surface) {
  const RowView view = row;  // So that the compiler knows that nothing written overlaps them.
  const SurfaceRow surface = row_surface;
  const int last = view.width - 1;
  FindSurface(view, offset, view.columns[0], depth[0], depth[1], above[0], below[0], depth[0], 0,
              surface);
  DRYDOCK_NO_OVERLAP
  for (int u = 1; u < last; ++u) {
    FindSurface(view, offset, view.columns[u], depth[u - 1], depth[u + 1], above[u], below[u],
                depth[u], u, surface);
  }
  FindSurface(view, offset, view.columns[last], depth[last - 1], depth[last], above[last],
              below[last], depth[last], last, surface);
}

DRYDOCK_VECTOR_CLONES
void Illuminate(int width, const float* sunward, const float* upward, const float* sun,
                const float* sky, float sun_share, float* light) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    // Diffuse light: all of it from above, a quarter (scattered back by water and ground) from
    // below.
    const float diffuse = (0.625F + 0.375F * upward[u]) * sky[u];
    const float value = sun_share * sunward[u] * sun[u] + (1.F - sun_share) * diffuse;
    light[u] = value >= 0.F ? value : 0.F;  // Also drops what is not a number.
  }
}

DRYDOCK_VECTOR_CLONES
void AddSeenThroughWater(int width, const ChannelWater& water, const float* albedo,
                         const float* light, const float* range, const float* slope,
                         const float* lit, float* direct, float* veil) {
  const float c = water.beam_attenuation, kd = water.diffuse_attenuation;
  const float lowest = 0.3F * c;
  const float brightness = water.daylight * water.weight;
  const float source = water.veil * c * brightness;
  // In perfectly clear water there is no veil, and beta is zero.
  const float guard = c > 0.F ? 0.F : 1.F;
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float beta = std::max(c - kd * slope[u], lowest);
    // Daylight at the surface point against that at the camera, exp(Kd s r), times exp(-c r):
    // exp(-beta r). Beyond 60 m nothing is left.
    const float transmitted = FastExp(-beta * std::min(range[u], 1000.F));
    direct[u] += brightness * albedo[u] * light[u] * transmitted;
    veil[u] += source / (beta + guard) * lit[u] * (1.F - transmitted);
  }
}

DRYDOCK_VECTOR_CLONES
void AddBlurred(int width, const BlurMix& given, const float* range, const float* direct,
                const float* less, const float* more, float* radiance) {
  const BlurMix mix = given;
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float tau = std::max(mix.scattering * std::min(range[u], 1000.F), 1e-3F);
    const float unbent = FastExp(-tau);
    const float variance = mix.variance * tau / (1.F - unbent);
    const float share =
        std::min(std::max((variance - mix.less_variance) * mix.inverse_variances, 0.F), 1.F);
    const float blurred = less[u] + share * (more[u] - less[u]);
    radiance[u] += blurred + unbent * (direct[u] - blurred);
  }
}

DRYDOCK_VECTOR_CLONES
void SlicesSeen(int width, int slices, float attenuation, const float* range, float* seen) {
  const auto count = static_cast<float>(slices);
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float share = 1.F - FastExp(-attenuation * std::min(range[u], 1000.F));
    seen[u] = std::max(count * share, 1e-6F);
  }
}

DRYDOCK_VECTOR_CLONES
void AddSlice(int width, int slice, const float* seen, const float* before, const float* here,
              float* lit) {
  const auto begin = static_cast<float>(slice);
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float part = std::min(std::max(seen[u] - begin, 0.F), 1.F);
    // The light of the slice that ends the way is known in its middle, which may lie behind what
    // the pixel sees, in another light: then the slice before it counts on.
    const float known = std::max(2.F * part - 1.F, 0.F);
    lit[u] += part * (before[u] + known * (here[u] - before[u]));
  }
}

DRYDOCK_VECTOR_CLONES
void DivideBy(int width, const float* divisor, float* values) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) values[u] /= divisor[u];
}

DRYDOCK_VECTOR_CLONES
void Interpolate(int width, const float* a, const float* b, float share, float* out) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) out[u] = a[u] + share * (b[u] - a[u]);
}

namespace {

template <int kSpacing>
inline __attribute__((always_inline)) void StretchBy(int count, const float* coarse, float* fine) {
  for (int i = 0; i < count; ++i) {
    const float slope = (coarse[i + 1] - coarse[i]) * (1.F / kSpacing);
    DRYDOCK_NO_OVERLAP
    for (int k = 0; k < kSpacing; ++k)
      fine[i * kSpacing + k] = coarse[i] + static_cast<float>(k) * slope;
  }
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Stretch(int count, int spacing, const float* coarse, float* fine) {
  // Known lengths make short loops fast.
  switch (spacing) {
    case 2:
      return StretchBy<2>(count, coarse, fine);
    case 4:
      return StretchBy<4>(count, coarse, fine);
    case 8:
      return StretchBy<8>(count, coarse, fine);
    case 16:
      return StretchBy<16>(count, coarse, fine);
    default:
      return StretchBy<32>(count, coarse, fine);
  }
}

}  // namespace drydock::sim::rows
