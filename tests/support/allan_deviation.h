// The overlapping Allan deviation.
#pragma once

#include <cstddef>
#include <vector>

namespace drydock::testing {

/// Root of half the mean square of the change from one average over `cluster` samples to the next,
/// over all pairs of neighbouring clusters, wherever they begin (IEEE 952-1997, annex C). `samples`
/// are evenly spaced; more than 2 * cluster of them.
double AllanDeviation(const std::vector<double>& samples, std::size_t cluster);

}  // namespace drydock::testing
