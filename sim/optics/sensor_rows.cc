#include "sim/optics/sensor_rows.h"

#include <algorithm>
#include <cmath>

#include "sim/optics/vector_clones.h"

namespace drydock::sim::rows {
namespace {

/// 32 well-mixed bits for each counter: multiply and fold, twice.
inline __attribute__((always_inline)) std::uint32_t Mix(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352DU;
  x ^= x >> 15;
  x *= 0x846CA68BU;
  x ^= x >> 16;
  return x;
}

/// Nearly normal, mean 0 and variance 1: the sum of four uniform bytes. Its tails end at 3.45
/// standard deviations, which eight bits of grey do not show.
inline __attribute__((always_inline)) float Bell(std::uint32_t bits) {
  const auto sum = static_cast<std::int32_t>((bits & 0xFFU) + ((bits >> 8) & 0xFFU) +
                                             ((bits >> 16) & 0xFFU) + (bits >> 24));
  constexpr float kInverseSigma = 0.0067658865F;  // 1 / sqrt(4 (256^2 - 1) / 12)
  return static_cast<float>(sum - 510) * kInverseSigma;
}

inline __attribute__((always_inline)) int ToIndex(float share, float last) {
  const float root = std::sqrt(std::min(std::max(0.F, share), 1.F));
  // Truncation vectorises, unlike rounding; the sum is never negative.
  const float rounded_up = root * last + 0.5F;
  return static_cast<int>(rounded_up);
}

}  // namespace

DRYDOCK_VECTOR_CLONES
void Read(const SensorRow& given, int width, const float* light, const float* falloff, int* index) {
  const SensorRow row = given;
  const auto last = static_cast<float>(row.last_code);
  DRYDOCK_NO_OVERLAP
  for (int u = 0; u < width; ++u) {
    const float share = light[u] * falloff[u] * row.scale;
    // A full well holds no more electrons, nor more of their noise.
    const float sigma = std::sqrt(std::min(share, 1.F) * row.shot + row.read);
    const float bell = Bell(Mix(row.key + static_cast<std::uint32_t>(u) * 0x9E3779B9U));
    index[u] = ToIndex(share + sigma * bell, last);
  }
}

}  // namespace drydock::sim::rows
