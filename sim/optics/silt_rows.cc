#include "sim/optics/silt_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/row_math.h"
#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {
namespace {

/// The error function, off by less than 1e-6: Abramowitz and Stegun (1964), 7.1.26, which is off by
/// 1.5e-7, and rounding.
inline __attribute__((always_inline)) float FastErf(float x) {
  const float a = std::abs(x);
  const float t = 1.F / (1.F + 0.3275911F * a);
  const float polynomial =
      t * (0.254829592F +
           t * (-0.284496736F + t * (1.421413741F + t * (-1.453152027F + t * 1.061405429F))));
  return std::copysign(1.F - polynomial * FastExp(-a * a), x);
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Rays(int width, const float* columns, float y, const float* depth, float* cosine,
          float* range) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float x = columns[u];
    const float length = std::sqrt(1.F + x * x + y * y);
    cosine[u] = 1.F / length;
    range[u] = std::min(depth[u] * length, 1e4F);
  }
}

DRYDOCK_VECTOR_CLONES
void AddDepth(int width, const BlobInCamera& given, const float* columns, float y,
              const float* cosine, const float* range, float* tau) {
  const BlobInCamera blob = given;
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float ray[3] = {columns[u] * cosine[u], y * cosine[u], cosine[u]};
    const float closest =
        blob.centre_C[0] * ray[0] + blob.centre_C[1] * ray[1] + blob.centre_C[2] * ray[2];
    const float off[3] = {blob.centre_C[0] - closest * ray[0], blob.centre_C[1] - closest * ray[1],
                          blob.centre_C[2] - closest * ray[2]};
    const float across2 = off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
    const float bell = FastExp(-across2 * blob.scale * blob.scale);
    tau[u] += blob.half_depth * bell *
              (FastErf((range[u] - closest) * blob.scale) + FastErf(closest * blob.scale));
  }
}

DRYDOCK_VECTOR_CLONES
void MakeOpacity(int width, float* tau) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) tau[u] = 1.F - FastExp(-tau[u]);
}

DRYDOCK_VECTOR_CLONES
void AddCloud(int width, int channels, const float* opacity, const float* source,
              const float* share, float* radiance) {
  if (channels == 1) {
    DRYDOCK_NO_OVERLAP
    for (int u = 0; u < width; ++u)
      radiance[u] += opacity[u] * (source[u] - share[u] * radiance[u]);
    return;
  }
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u)
    radiance[3 * u] += opacity[u] * (source[u] - share[u] * radiance[3 * u]);
}

}  // namespace drydock::sim::rows
