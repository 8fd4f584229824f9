// The usual soft edge.
#pragma once

#include <algorithm>

namespace drydock::scenes {

/// 0 up to `low`, 1 from `high` on, and 3 t^2 - 2 t^3 in between.
inline double SmoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace drydock::scenes
