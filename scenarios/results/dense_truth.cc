#include "scenarios/results/dense_truth.h"

#include <algorithm>

namespace drydock {
namespace {

bool IsEarlier(const StampedPose& a, const StampedPose& b) { return a.t < b.t; }

/// Whether `pose` falls between two poses of `truth`, on neither, that are at most `max_gap` apart.
bool HasCloseNeighbours(const Trajectory& truth, const StampedPose& pose, Duration max_gap) {
  const auto after = std::lower_bound(truth.begin(), truth.end(), pose, IsEarlier);
  if (after == truth.begin() || after == truth.end() || after->t == pose.t) return false;
  return after->t - (after - 1)->t <= max_gap;
}

}  // namespace

Trajectory AddInterpolated(const Trajectory& truth, const Trajectory& estimate, Duration max_gap) {
  Trajectory between;
  for (const StampedPose& pose : estimate) {
    if (HasCloseNeighbours(truth, pose, max_gap))
      between.push_back({pose.t, *Interpolate(truth, pose.t)});
  }
  Trajectory all(truth.size() + between.size());
  std::merge(truth.begin(), truth.end(), between.begin(), between.end(), all.begin(), IsEarlier);
  return all;
}

}  // namespace drydock
