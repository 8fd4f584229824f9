// The inner loops of the image sensor: one row a call, plain arrays that do not overlap, the same
// bits on every instruction set (see optics_rows.h).
#pragma once

#include <cstdint>

namespace drydock::sim::rows {

struct SensorRow {
  float scale = 0.F;      ///< Light to share of full scale.
  float shot = 0.F;       ///< Variance per share of full scale.
  float read = 0.F;       ///< Variance of the rest.
  std::uint32_t key = 0;  ///< Of the row's noise.
  int last_code = 0;      ///< Index of full scale.
};

/// The square root of what each of `width` samples reads, in 0 .. last_code. Without
/// variances there is no noise.
void Read(const SensorRow& row, int width, const float* light, const float* falloff, int* index);

}  // namespace drydock::sim::rows
