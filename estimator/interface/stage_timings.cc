#include "estimator/interface/stage_timings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drydock {
namespace {

/// The smallest value that at least `share` of the `sorted` ones do not exceed.
double Quantile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace

void StageClock::Add(const std::string& stage, double seconds) {
  auto found = std::find_if(stages_.begin(), stages_.end(),
                            [&](const auto& entry) { return entry.first == stage; });
  if (found == stages_.end()) found = stages_.insert(found, {stage, {}});
  found->second.push_back(seconds);
}

EstimatorTimings StageClock::Summary() const {
  EstimatorTimings timings;
  timings.reserve(stages_.size());
  for (const auto& [name, costs] : stages_) {
    std::vector<double> sorted = costs;
    std::sort(sorted.begin(), sorted.end());
    timings.push_back({name, sorted.size(), std::accumulate(sorted.begin(), sorted.end(), 0.0),
                       1e3 * Quantile(sorted, 0.5), 1e3 * Quantile(sorted, 0.99)});
  }
  return timings;
}

}  // namespace drydock
