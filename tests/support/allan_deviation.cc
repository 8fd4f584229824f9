#include "tests/support/allan_deviation.h"

#include <cmath>
#include <stdexcept>

namespace drydock::testing {

double AllanDeviation(const std::vector<double>& samples, std::size_t cluster) {
  if (cluster == 0 || samples.size() < 2 * cluster) throw std::invalid_argument("too few samples");
  // Sums from the first sample's value, for what does not change has no part in it.
  std::vector<double> sums = {0.0};
  sums.reserve(samples.size() + 1);
  for (const double sample : samples) sums.push_back(sums.back() + (sample - samples.front()));
  double squares = 0.0;
  const std::size_t pairs = sums.size() - 2 * cluster;
  for (std::size_t k = 0; k < pairs; ++k) {
    const double change = sums[k + 2 * cluster] - 2.0 * sums[k + cluster] + sums[k];
    squares += change * change;
  }
  return std::sqrt(0.5 * squares / static_cast<double>(pairs)) / static_cast<double>(cluster);
}

}  // namespace drydock::testing
