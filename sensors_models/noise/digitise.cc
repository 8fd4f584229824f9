#include "sensors_models/noise/digitise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drydock {

double Digitise(double value, double range, double resolution) {
  const double limit = range > 0.0 ? range : std::numeric_limits<double>::infinity();
  const double clipped = std::clamp(value, -limit, limit);
  if (resolution == 0.0) return clipped;
  // A range of whole steps stays one where the division does not come out even.
  const double last_step = std::floor(limit / resolution * (1.0 + 1e-12));
  return resolution * std::clamp(std::round(clipped / resolution), -last_step, last_step);
}

}  // namespace drydock
