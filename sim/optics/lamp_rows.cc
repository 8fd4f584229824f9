#include "sim/optics/lamp_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/row_math.h"
#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {

DRYDOCK_VECTOR_CLONES
void Normals(const RowView& row, const float* above, const float* depth, const float* below,
             const NormalRow& row_normal) {
  const RowView view = row;
  const NormalRow normal = row_normal;
  const int last = view.width - 1;
  const auto store = [&normal](int u, const Normal& n) __attribute__((always_inline)) {
    normal.x[u] = n.x;
    normal.y[u] = n.y;
    normal.z[u] = n.z;
  };
  store(0, NormalOf(view, view.columns[0], depth[0], depth[1], above[0], below[0], depth[0]));
  DRYDOCK_NO_OVERLAP
  for (int u = 1; u < last; ++u) {
    store(u, NormalOf(view, view.columns[u], depth[u - 1], depth[u + 1], above[u], below[u],
                      depth[u]));
  }
  store(last, NormalOf(view, view.columns[last], depth[last - 1], depth[last], above[last],
                       below[last], depth[last]));
}

DRYDOCK_VECTOR_CLONES
void LampOnSurfaces(const RowView& view, const Lamp& given, const float* depth, const float* range,
                    const NormalRow& row_normal, float* share, float* way) {
  const Lamp lamp = given;
  const NormalRow normal = row_normal;
  const float* columns = view.columns;
  const float y = view.y;
  const int width = view.width;
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float z = depth[u];
    const float to_x = lamp.position_C[0] - columns[u] * z;
    const float to_y = lamp.position_C[1] - y * z;
    const float to_z = lamp.position_C[2] - z;
    // Where nothing is seen this is not a number; the order of the arguments makes one of it.
    const float squared = std::max(lamp.nearest, to_x * to_x + to_y * to_y + to_z * to_z);
    const float distance = std::sqrt(squared);
    const float per_distance = 1.F / distance;
    const float incidence =
        (normal.x[u] * to_x + normal.y[u] * to_y + normal.z[u] * to_z) * per_distance;
    const float off_axis =
        -(lamp.axis_C[0] * to_x + lamp.axis_C[1] * to_y + lamp.axis_C[2] * to_z) * per_distance;
    const float beam = off_axis > 0.F ? FastExp(lamp.sharpness * (off_axis - 1.F)) : 0.F;
    const float value = beam * incidence * per_distance * per_distance;
    share[u] = value > 0.F ? value : 0.F;  // Also drops what is not a number.
    way[u] = std::min(1000.F, distance + range[u]);
  }
}

DRYDOCK_VECTOR_CLONES
void AddLampLight(int width, float brightness, float attenuation, const float* albedo,
                  const float* lit, const float* share, const float* way, float* direct) {
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u)
    direct[u] += brightness * albedo[u] * lit[u] * share[u] * FastExp(-attenuation * way[u]);
}

DRYDOCK_VECTOR_CLONES
void AddPiece(int width, float begin, float end, const float* range, const float* piece,
              float* sum) {
  const float per_metre = 1.F / (end - begin);
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u)
    sum[u] += piece[u] * std::min(std::max((range[u] - begin) * per_metre, 0.F), 1.F);
}

namespace {

/// How much a corner's light says of a pixel: not at all where it belongs to another surface.
inline __attribute__((always_inline)) float Kinship(float here, float there) {
  // A twentieth of the depth; infinite depths give what is not a number, and 0.
  const float share = 1.F - std::abs(there - here) / (0.05F * here);
  return share > 0.F ? share : 0.F;
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void SpreadFromRaster(int width, int raster, float down, const float* depth,
                      const RasterCorners& corners_above, const RasterCorners& corners_below,
                      float* value) {
  const RasterCorners above = corners_above, below = corners_below;
  const float per_pixel = 1.F / static_cast<float>(raster);
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float across = static_cast<float>(u & (raster - 1)) * per_pixel;
    const float z = depth[u];
    // A little of each corner is left in any case, for pixels that are like none.
    const float w00 = (1.F - across) * (1.F - down) * (Kinship(z, above.depth[0][u]) + 1e-4F);
    const float w01 = across * (1.F - down) * (Kinship(z, above.depth[1][u]) + 1e-4F);
    const float w10 = (1.F - across) * down * (Kinship(z, below.depth[0][u]) + 1e-4F);
    const float w11 = across * down * (Kinship(z, below.depth[1][u]) + 1e-4F);
    const float sum = w00 * above.value[0][u] + w01 * above.value[1][u] + w10 * below.value[0][u] +
                      w11 * below.value[1][u];
    value[u] = sum / (w00 + w01 + w10 + w11);
  }
}

}  // namespace drydock::sim::rows
